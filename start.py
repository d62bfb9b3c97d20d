"""Sets kinoedu up in .venv beside this file, once, and then starts a command.

This file must parse on any Python, so that one which is too old says so in a line: no f-strings, no
annotations.
"""

# ruff: noqa: UP031, RUF005 (newer ways to format and join would not parse there)
import errno
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time

HELP = """usage: python start.py [command ...]

  python start.py                    set up, then open the course in JupyterLab
  python start.py test [arguments]   set up, add the test tools, run pytest
  python start.py site               set up, then write the course as a site into build/site
  python start.py command ...        set up, then run a command of kinoedu, for example:
                                     python start.py plan --help
  python start.py wheelhouse FOLDER  set up, then download all packages into a folder, from which
                                     a computer without network can be set up with:
  python start.py --wheels FOLDER ...

The set-up is done once, in .venv beside this file, and needs the network only then.
"""
HERE = os.path.dirname(os.path.abspath(__file__))
VENV = os.path.join(HERE, ".venv")
LOG = os.path.join(VENV, "install.log")
STAMP = os.path.join(VENV, "installed.json")
LOCK = os.path.realpath(VENV) + ".lock"  # one for all copies of the course that share a .venv
PYTHON = os.path.join(VENV, *(["Scripts", "python.exe"] if os.name == "nt" else ["bin", "python"]))
COURSE, TEACHING, TESTS = "environment.txt", "solutions/environment.txt", "tests/environment.txt"
SITE = "docs/environment.txt"
MEGABYTES = {COURSE: 700, TEACHING: 100, TESTS: 500, SITE: 100}
TEACHING_COMMANDS = ["release", "export"]
PIP_OPTIONS = ["--no-deps", "--only-binary", ":all:", "-r"]

# Variables that would lead .venv to the packages of the environment this file was called from;
# one, common in containers, that makes every process translate all it imports: three times slower;
# and one, common on servers, with which a lesson shows no figures.
FOREIGN = re.compile(
    "CONDA|VIRTUAL_ENV|PYTHON(PATH|HOME|STARTUP|DONTWRITEBYTECODE)$|__PYVENV_LAUNCHER__"
    "|PIP_(TARGET|PREFIX|ROOT)$|MPLBACKEND$"
)

# Patterns in the messages of pip, uv, venv and the operating systems, each with its advice.
# The first that matches is printed.
CAUSES = [
    (
        r"no space left|not enough space|os error (28|112)\b|quota",
        "the disk is full; make room and run this again",
    ),
    (
        r"long path",
        "the path of this folder is too long; move it to a shorter one and run this again",
    ),
    (
        r"no module named '?(venv|ensurepip)|ensurepip is (not available|disabled)",
        "this Python cannot make environments; install its venv module (Debian, Ubuntu: sudo apt "
        "install python3-venv)",
    ),
    (
        r"connection|timed? ?out|getaddrinfo|name resolution|failed to fetch|error sending"
        r"|dns error|sslerror|proxyerror",
        "packages cannot be downloaded; connect to the network and run this again",
    ),
    (
        r"no matching distribution|no solution found|no wheels|requires-python",
        "a package is not made for this Python or computer; use Python 3.11 to 3.14, 64 bits, and "
        "--wheels of its like",
    ),
    (
        r"permission|not permitted|access is denied|os error (5|13|30)\b|read-only",
        "cannot write in %s; close what runs from it, or copy the folder to a place of yours"
        % HERE,
    ),
]


class Stop(Exception):
    """The set-up cannot go on; the message says why and what to do."""


def main(arguments):
    """Do what the arguments ask; the exit status."""
    try:
        require_python(sys.version_info)
        if arguments[:1] in (["-h"], ["--help"]):
            sys.stdout.write(HELP)
            return 0
        return start(arguments)
    except KeyboardInterrupt:
        return 130
    except Stop as stop:
        write_line("start.py: %s" % stop)
    except (OSError, subprocess.CalledProcessError) as error:
        write_line("start.py: %s" % explain(str(error)))
    return 2


def require_python(version):
    """Refuse a Python on which kinoedu does not run."""
    if tuple(version[:2]) < (3, 11):
        raise Stop(
            "kinoedu needs Python 3.11 or newer, and this is Python %d.%d" % tuple(version[:2])
        )


def start(arguments):
    """Set up what the command needs, and become that command."""
    if arguments[:1] == ["--wheels"]:
        os.environ["KINOEDU_WHEELS"] = folder_of(arguments)
        arguments = arguments[2:]
    if arguments[:1] == ["wheelhouse"]:
        return gather(folder_of(arguments))
    if arguments[:1] == ["test"]:
        set_up([COURSE, TEACHING, TESTS, SITE])
        os.chdir(HERE)
        return become(["-m", "pytest", "--rootdir", HERE] + arguments[1:])
    if arguments[:1] == ["site"]:
        set_up([COURSE, SITE])
        os.chdir(HERE)
        return become(
            ["-m", "sphinx", "-j", "auto", "-c", "docs", "-d", "build/doctrees", ".", "build/site"]
            + arguments[1:]
        )
    if arguments[:1] == ["slides"]:
        set_up([COURSE, SITE])
        return become(["-m", "kinoedu"] + arguments)
    set_up([COURSE, TEACHING] if arguments[:1] and arguments[0] in TEACHING_COMMANDS else [COURSE])
    return become(["-m", "kinoedu"] + (arguments or ["lab"]))


def folder_of(arguments):
    """The folder that stands after a word; whole, as the installers run elsewhere."""
    if len(arguments) < 2:
        raise Stop("%s needs a folder; see python start.py --help" % arguments[0])
    return os.path.abspath(arguments[1])


def gather(folder):
    """Download, as wheels for computers like this one, all that .venv was brought to."""
    set_up([COURSE])
    with open(LOCK, "ab") as lock:
        wait_for(lock)
        open(LOG, "wb").close()
        show_progress = progress("downloading wheels into %s" % folder)
        stamp = installed()
        for name in sorted(name for name in MEGABYTES if stamp.get(name)):
            if not with_pip(name, lock, show_progress, task=["download", "--dest", folder]):
                raise Stop("%s (log: %s)" % (explain(read_log()), LOG))
        show_progress("\n")
    return 0


def become(arguments):
    """Run Python in place of this process, deaf to modules that happen to lie in the current
    folder.
    """
    line = [PYTHON, "-P"] + arguments
    if os.name != "nt":
        os.execve(PYTHON, line, environment())
    import signal  # exec on Windows would give the prompt back at once

    # Ctrl-C reaches the command too, and is its to answer
    signal.signal(signal.SIGINT, lambda *_: None)
    return subprocess.call(line, env=environment())


def environment():
    """The caller's environment variables as if .venv, and nothing else, were activated."""
    kept = {name: value for name, value in os.environ.items() if not FOREIGN.match(name)}
    path = os.path.dirname(PYTHON) + os.pathsep + kept.get("PATH", os.defpath)
    return dict(kept, VIRTUAL_ENV=VENV, PATH=path, PIP_USER="0")


def set_up(pins):
    """Bring .venv to what the files pin. When it is there already nothing is written and nobody
    waits.
    """
    if not missing(pins):
        return
    with open(LOCK, "ab") as lock:
        wait_for(lock)
        if os.path.exists(LOG):
            os.remove(LOG)
        tools = ([with_uv] if shutil.which("uv") else []) + [with_pip]
        if not any(bring(pins, tool, lock) for tool in tools):
            raise Stop("%s (log: %s)" % (explain(read_log()), LOG))


def bring(pins, tool, lock):
    """Install what is missing; into a new .venv where the Python of the old does not fit."""
    if not installed():
        make_venv(lock)
    top = packages()
    with open(os.path.join(top, "kinoedu.pth"), "w") as file:
        file.write(os.path.relpath(HERE, top) + "\n")  # relative: it holds when the folder is moved
    return all(install(name, tool, lock) for name in missing(pins))


def missing(pins):
    """The files whose content is not what .venv was last brought to."""
    stamp = installed()
    return [name for name in pins if stamp.get(name) != digest(name)]


def digest(name):
    """The digest of a file with pins; Stop where this copy of the course lacks the file."""
    if not os.path.exists(os.path.join(HERE, name)):
        raise Stop(
            "this copy of the course is for students: %s is not in it, nor what needs it" % name
        )
    with open(os.path.join(HERE, name), "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()


def installed():
    """Read the stamp of .venv: digests, and None for what may be half-written.

    It is empty if .venv must be made: it is not there, or its Python is gone or has become another.
    """
    python = binary_interface()
    if python is None:
        return {}
    try:
        with open(STAMP) as file:
            stamp = json.load(file)
        return stamp if stamp["python"] == python else {}
    except (OSError, ValueError, KeyError, TypeError):  # lost or damaged: who knows what is there
        return dict(dict.fromkeys(MEGABYTES), python=python) if os.path.isdir(packages()) else {}


def write_stamp(stamp):
    """Write it whole or not at all."""
    with open(STAMP + ".new", "w") as file:
        json.dump(stamp, file)
    os.replace(STAMP + ".new", STAMP)


def binary_interface():
    """Ask what compiled packages must fit, such as .cpython-311-x86_64-linux-gnu.so.

    It is None if no Python runs in .venv.
    """
    try:
        return ask("importlib.machinery.EXTENSION_SUFFIXES[0]")
    except (subprocess.CalledProcessError, ValueError):
        return None
    except OSError as error:
        if error.errno in (errno.ENOENT, errno.ENOTDIR, errno.ENOEXEC, errno.EACCES):
            return None
        raise  # for example no memory, which says nothing about .venv


def packages():
    """The folder of .venv that packages are installed in."""
    return ask("sysconfig.get_path('purelib')")


def contents():
    """Find each installed file's size and time, but for the installer itself and bytecode."""
    found, top = {}, packages()
    others = re.compile("_?(pip|setuptools|pkg_resources|distutils)|.*__pycache__")
    for folder, _, names in os.walk(top):
        for path in [os.path.join(folder, name) for name in names]:
            if not others.match(os.path.relpath(path, top)):
                found[path] = (os.lstat(path).st_size, os.lstat(path).st_mtime)
    return found


def ask(expression):
    """The value of an expression in the Python of .venv."""
    code = "import importlib.machinery, json, sysconfig; print(json.dumps(%s))" % expression
    with open(os.devnull, "w") as nothing:
        return json.loads(
            subprocess.check_output([PYTHON, "-I", "-c", code], env=environment(), stderr=nothing)
        )


def make_venv(lock):
    """Make an empty .venv in place of whatever was there, unless programs run from that."""
    make_way()
    if os.path.exists(STAMP):
        os.remove(STAMP)  # first, or a .venv whose deletion was interrupted would seem whole
    # we may run on the .venv that is deleted here
    base = getattr(sys, "_base_executable", None) or sys.executable
    line = [base, "-I", "-m", "venv", "--clear", "--without-pip", os.path.realpath(VENV)]
    made = subprocess.run(
        line,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        env=environment(),
        **shared(lock)
    )
    if made.returncode:
        raise Stop(explain(made.stdout.decode("utf-8", "replace")))
    write_stamp({"python": binary_interface()})


def make_way():
    """Refuse while programs run from the old .venv. Where nothing lists them, move it away."""
    old = os.path.realpath(VENV)
    if not os.path.isdir(old):
        users = []
    elif sys.platform.startswith("linux"):
        numbers = [name for name in os.listdir("/proc") if name.isdigit()]
        users = ["process " + pid for pid in numbers if runs_from(old, pid)]
    else:
        users = [] if move_away(old) else ["programs"]
    if users:
        raise Stop(
            "the Python of %s is gone or has become another, but that folder is in use by "
            "%s; close what runs from it, and run this again" % (old, ", ".join(users))
        )


def move_away(folder):
    """Rename and delete a folder. Tell success: Windows refuses while programs run from it."""
    shutil.rmtree(folder + ".old", ignore_errors=True)  # of a run that was killed
    try:
        os.rename(folder, folder + ".old")
    except OSError:
        return False
    shutil.rmtree(folder + ".old", ignore_errors=True)
    return True


def runs_from(folder, pid):
    """Whether another process was called by a path in the folder, or has loaded a file of it."""

    def read(name):
        try:
            with open("/proc/%s/%s" % (pid, name), "rb") as file:
                return os.fsdecode(file.read())
        except OSError:
            return ""  # it has ended, or is of a user whose affairs are hidden from us

    called = read("cmdline").partition("\0")[0]
    if os.sep not in called:  # a shell found it
        path = re.search("(?:^|\0)PATH=([^\0]*)", read("environ"))
        places = path.group(1).split(os.pathsep) if path else []
        places = [os.path.join(place, called) for place in places]
        called = next((place for place in places if os.path.lexists(place)), os.sep)
    home = os.path.realpath(os.path.join("/proc/%s/cwd" % pid, os.path.dirname(called)))
    loaded = " %s%s" % (folder, os.sep) in read("maps")
    return int(pid) != os.getpid() and (loaded or (home + os.sep).startswith(folder + os.sep))


def install(name, tool, lock):
    """Install what a file pins; again, where that may be half-written.

    Meanwhile the stamp has None for all that may be so after a kill or a failure.
    """
    stamp = installed()
    if name not in stamp and shutil.disk_usage(VENV).free < MEGABYTES[name] * 10**6:
        raise Stop(
            "%d MB of disk are needed in %s; make room and run this again" % (MEGABYTES[name], HERE)
        )
    how = tool.__name__.replace("_", " ")
    text = "installing %s %s (%d MB, once, a few minutes)" % (name, how, MEGABYTES[name])
    show_progress = progress(text)
    again = name in stamp and stamp[name] is None
    if again:
        forget_the_half_written()
    before = contents()
    touched = set(stamp) - {"python"} if again else {name}  # again: what other files pin too
    write_stamp(dict(stamp, **dict.fromkeys(touched)))
    done = False
    try:
        done = tool(name, lock, show_progress, ["--force-reinstall"] if again else [])
        return done
    finally:
        show_progress("\n")
        if done:
            write_stamp(dict(stamp, **{name: digest(name)}))
        elif contents() == before:
            write_stamp(stamp)  # stopped while downloading: what was whole still is


def forget_the_half_written():
    """Delete descriptions of packages that are not whole: pip would refuse to replace those."""
    top = packages()
    for name in os.listdir(top):
        folder = os.path.join(top, name)
        if name.endswith(".dist-info") and not {"METADATA", "RECORD"} <= set(os.listdir(folder)):
            shutil.rmtree(folder)


def with_uv(name, lock, show_progress, again=()):
    """Install what a file pins with the uv that the user has."""
    line = [shutil.which("uv"), "pip", "install", "--python", PYTHON] + list(again)
    return finish(line + source() + PIP_OPTIONS + [name], lock, show_progress)


def with_pip(name, lock, show_progress, again=(), task=("install", "--no-compile")):
    """Compiling bytecode is left to the first import, as most modules are never imported."""
    pip = [PYTHON, "-I", "-m", "pip"] + list(task) + list(again)
    pip += ["--no-input", "--disable-pip-version-check", "--retries", "2"]
    return finish([PYTHON, "-I", "-m", "ensurepip"], lock, show_progress) and finish(
        pip + source() + PIP_OPTIONS + [name], lock, show_progress
    )


def source():
    """Where packages come from: the user's index, or nothing but a folder of wheels."""
    folder = os.environ.get("KINOEDU_WHEELS")
    if folder and not os.path.isdir(folder):
        raise Stop("there is no folder of wheels at %s" % folder)
    return ["--no-index", "--find-links", os.path.abspath(folder)] if folder else []


def finish(line, lock, show_progress):
    """Run an installer to its end, its output in the log; whether it succeeded."""
    with open(LOG, "ab") as log:
        try:
            child = subprocess.Popen(
                line,
                stdin=subprocess.DEVNULL,
                stdout=log,
                stderr=log,
                cwd=HERE,
                env=environment(),
                **shared(lock)
            )
        except OSError as error:
            log.write(str(error).encode("utf-8", "replace"))
            return False
        try:
            while child.poll() is None:
                show_progress()
                time.sleep(0.1)
        finally:
            child.terminate()
            child.wait()
        return child.returncode == 0


def progress(text):
    """A function that shows the seconds since now, on one line of a terminal."""
    began, live = time.monotonic(), sys.stderr.isatty()
    if not live:
        write_line(text)

    def show_progress(end=""):
        if live:
            sys.stderr.write("\r%s: %d s%s" % (text, time.monotonic() - began, end))
            sys.stderr.flush()

    return show_progress


def read_log():
    """The output of the installers."""
    with open(LOG, errors="replace") as file:
        return file.read()


def explain(text):
    """One line for what an installer or the operating system wrote."""
    for pattern, advice in CAUSES:
        if re.search("(?i)" + pattern, text):
            return advice
    return "the set-up failed: " + "".join(text.strip().splitlines()[-1:])


def write_line(line):
    """Write a line to standard error, at once."""
    sys.stderr.write(line + "\n")
    sys.stderr.flush()


def wait_for(lock):
    """Take the lock on .venv; the system frees it when its last holder has died."""
    if not taken(lock):
        write_line("another start.py is setting up; waiting")
        while not taken(lock):
            time.sleep(0.2)


def taken(lock):
    """Take the lock if nobody has it; whether it is ours now."""
    try:
        if os.name == "nt":
            import msvcrt

            # past the end: what is locked cannot be read
            os.lseek(lock.fileno(), 1 << 30, os.SEEK_SET)
            msvcrt.locking(lock.fileno(), msvcrt.LK_NBLCK, 1)
        else:
            import fcntl

            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    except OSError:
        pass  # some network disks know no locks: go on without
    return True


def shared(lock):
    """Lets an installer hold the lock too, should this process be killed before it."""
    return {} if os.name == "nt" else {"pass_fds": [lock.fileno()]}


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
