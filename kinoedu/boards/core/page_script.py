"""The script with which a page without a kernel shows recorded boards, and lets them answer."""

import json

from ...figures import palette
from ...messages import get_template
from ...support.json_fields import JsonObject
from .canvas import CORE, front_messages, widget_script
from .recorded import VERSION

BROWSER = CORE.parent.parent / "browser"
WORDS = ("recorded", "live", "seed", "share", "shared", "unjudged")  # the messages of `site`


def page_script(live: JsonObject | None = None) -> str:
    """One script, which works from a disk too: modules do not.

    live : the bodies that lie beside the page, from `describe_bodies`. None where boards only play.
    """
    files = CORE / "recorded.js", BROWSER / "live.js", BROWSER / "worker.js"
    player, answers, worker = (file.read_text(encoding="utf-8") for file in files)
    words = {name: get_template(f"site.{name}", "en") for name in WORDS} | front_messages()
    values = {
        "WORDS": words,
        "PALETTE": palette.THEMES,
        "VERSION": VERSION,
        "LIVE": live or {"bodies": {}},
        "WORKER": worker,
    }
    constants = "\n".join(f"const {name} = {json.dumps(value)};" for name, value in values.items())
    board = widget_script(CORE / "board.js").replace("export default", "const widget =")
    return f"(() => {{\n{constants}\n{board}\n{answers}\n{player}}})();\n"
