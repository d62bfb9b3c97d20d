"""The lab's connection to its kernels, which sends small messages at once.

By default a message waits until the one before has arrived (Nagle's algorithm), which browsers
acknowledge after 40 ms: too long for boards, whose every answer consists of three messages.
"""

from typing import Any

from jupyter_server.services.kernels.connection.channels import ZMQChannelsWebsocketConnection


class PromptConnection(ZMQChannelsWebsocketConnection):
    """A connection of one page with one kernel."""

    def connect(self) -> Any:
        """Connect them."""
        self.websocket_handler.set_nodelay(True)
        return super().connect()
