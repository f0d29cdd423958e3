"""LinuxCNC without hardware or window: configured for a kinematics module, sent to poses or given a part program, and
asked for its joints: at rest at every pose, or in every servo period of the program.

LinuxCNC is only run: it starts this file as its display program, and that drives it through its Python module.

Usage: linuxcnc_session.py TASK RESULT   (what LinuxCNC starts)
"""

import json
import os
import pwd
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path


class NotStarted(Exception):
    """LinuxCNC does not run here."""


class TooSlow(Exception):
    """This computer is too busy for LinuxCNC: nothing was compared, which is no difference."""


# LinuxCNC's own clock is the servo cycle: on a busy computer it stands still, and so does all that is waited for.
# Cycles without any change after which nothing more is expected, and how long they take on a computer that keeps up, s.
STILL_CYCLES = 30_000
STILL_S = 30.0
# So many times as long, and the computer is too busy; sooner LinuxCNC itself stands where it should not.
SLOWED = 2.0
# Looks of this program at a servo cycle that does not come: a computer that lets it look so often is not too busy for a cycle.
MAX_LOOKS = 60_000
# Cycles that must pass between two equal readings of joints at rest.
REST_CYCLES = 3
# Cycles that are sampled at rest before and after a program.
AROUND_CYCLES = 200
# Time without any sign of LinuxCNC after which it is given up, s.
SILENT_S = 180
# What LinuxCNC says of a busy computer: its cycles were late, and it goes on.
LATE = "Unexpected realtime delay"


def write_configuration(folder, module, display):
    """INI and HAL files of a machine whose joints follow at once, with the module's limits (speed and acceleration an
    axis) or none."""
    axes = module["axes"]
    ini = f"""[EMC]\nMACHINE = peer\nVERSION = 1.1
[DISPLAY]\nDISPLAY = {display}
[RS274NGC]\nPARAMETER_FILE = {folder}/peer.var
[EMCMOT]\nEMCMOT = motmod\nCOMM_TIMEOUT = 1.0\nSERVO_PERIOD = 1000000
[TASK]\nTASK = milltask\nCYCLE_TIME = 0.001
[EMCIO]\nEMCIO = io\nCYCLE_TIME = 0.1\nTOOL_TABLE = {folder}/peer.tbl
[HAL]\nHALFILE = {folder}/peer.hal
[KINS]\nKINEMATICS = {module["kinematics"]} coordinates={axes}\nJOINTS = {len(axes)}
[TRAJ]\nCOORDINATES = {axes}\nLINEAR_UNITS = mm\nANGULAR_UNITS = degree
DEFAULT_LINEAR_VELOCITY = 1e6\nMAX_LINEAR_VELOCITY = 1e6\nMAX_LINEAR_ACCELERATION = 1e9
DEFAULT_ANGULAR_VELOCITY = 1e6\nMAX_ANGULAR_VELOCITY = 1e6\nMAX_ANGULAR_ACCELERATION = 1e9\n"""
    hal = f"""loadrt [KINS]KINEMATICS
loadrt [EMCMOT]EMCMOT servo_period_nsec=[EMCMOT]SERVO_PERIOD num_joints=[KINS]JOINTS
addf motion-command-handler servo-thread\naddf motion-controller servo-thread
net enable iocontrol.0.user-enable-out iocontrol.0.emc-enable-in
loadrt sampler depth=16000 cfg={"f" * len(axes)}
setp sampler.0.enable 0
addf sampler.0 servo-thread
loadrt threadtest
addf threadtest.0.increment servo-thread\n"""
    for joint, axis in enumerate(axes):
        kind = "ANGULAR" if axis in "ABC" else "LINEAR"
        speed, acceleration = module.get("limits", {}).get(axis, (1e6, 1e9))
        fast = f"MAX_VELOCITY = {speed}\nMAX_ACCELERATION = {acceleration}\nMIN_LIMIT = -1e6\nMAX_LIMIT = 1e6\n"
        ini += f"[AXIS_{axis}]\n{fast}[JOINT_{joint}]\nTYPE = {kind}\n{fast}FERROR = 1e9\nMIN_FERROR = 1e9\nHOME = 0\n"
        ini += "HOME_SEARCH_VEL = 0\nHOME_LATCH_VEL = 0\nHOME_SEQUENCE = 0\n"
        hal += f"net joint{joint} joint.{joint}.motor-pos-cmd joint.{joint}.motor-pos-fb sampler.0.pin.{joint}\n"
    (folder / "peer.ini").write_text(ini)
    (folder / "peer.hal").write_text(hal)
    (folder / "peer.tbl").touch()


class Hal:
    """What HAL itself says: unlike LinuxCNC's status it is never late."""

    def __init__(self, joints):
        import hal

        self.value, self.joint_count = hal.get_value, joints
        self.component = hal.component("peer-drive")
        self.component.ready()

    def cycles(self):
        """Servo cycles since LinuxCNC was started."""
        return self.value("threadtest.0.count")

    def joints(self):
        return [self.value(f"joint.{joint}.motor-pos-cmd") for joint in range(self.joint_count)]


class Session:
    """Inside LinuxCNC: sends it to poses and plays programs."""

    def __init__(self, task, folder):
        import linuxcnc

        self.linuxcnc, self.task, self.folder = linuxcnc, task, folder
        self.places = ["XYZABCUVW".index(axis) for axis in task["axes"]]
        self.command, self.status, self.errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()
        self.hal = Hal(len(self.places))
        self.signs = 0

    def alive(self):
        """A sign for who waits outside."""
        self.signs += 1
        (self.folder / "signs").write_text(str(self.signs))

    def wait(self, ready, what):
        """Until `ready`; gives up when nothing has changed for many servo cycles, or no cycle comes. Only cycles that come too
        slowly are the computer's fault."""
        seen, since, begun = None, self.hal.cycles(), time.monotonic()
        cycle, looks = since, 0
        while True:
            self.status.poll()
            if ready():
                return
            message = self.errors.poll()
            if message and LATE not in message[1]:
                raise RuntimeError(f"LinuxCNC does not {what}: {message[1]}")
            status = self.status
            state = (status.echo_serial_number, status.task_state, status.interp_state, status.current_line, self.hal.joints())
            if state != seen:
                seen, since, begun = state, self.hal.cycles(), time.monotonic()
                self.alive()
            now = self.hal.cycles()
            cycle, looks = now, looks + 1 if now == cycle else 0
            if looks > MAX_LOOKS:
                raise RuntimeError(f"LinuxCNC does not {what}: its servo thread stands")
            if now - since > STILL_CYCLES:
                took = time.monotonic() - begun
                text = f"LinuxCNC does not {what} within {STILL_CYCLES} servo cycles ({took:.0f} s) in which nothing changes"
                raise TooSlow(text) if took > SLOWED * STILL_S else RuntimeError(f"{text}: {self.where()}")
            time.sleep(0.0005)

    def where(self):
        """Where it stands, for who looks for the difference."""
        position = [self.status.position[place] for place in self.places]
        return f"position {position}, joints {self.hal.joints()}"

    def pass_cycles(self, count):
        end = self.hal.cycles() + count
        self.wait(lambda: self.hal.cycles() >= end, "run its servo thread")

    def rest(self):
        """Waits until joints are the same before and after some servo cycles; their positions."""
        while True:
            before = self.hal.joints()
            self.pass_cycles(REST_CYCLES)
            if self.hal.joints() == before:
                return before

    def is_at(self, pose, within):
        return all(abs(self.status.position[place] - word) < within for place, word in zip(self.places, pose))

    def go(self, pose):
        """Joints at a pose."""
        words = " ".join(f"{axis}{word:.9f}" for axis, word in zip(self.task["axes"], pose))
        self.command.mdi(f"G53 G0 {words}")

        def there():
            done = self.status.state == self.linuxcnc.RCS_DONE and self.status.inpos
            return done and self.status.echo_serial_number == self.command.serial and self.is_at(pose, 1e-9)

        self.wait(there, f"reach {words}")
        return self.rest()

    def play(self):
        """Joints in every servo cycle of the program, and some at rest around it."""
        status, linuxcnc = self.status, self.linuxcnc
        with open(self.folder / "rows", "w") as file:
            sampler = subprocess.Popen(["halsampler"], stdout=file)
        sample = lambda on: subprocess.run(["halcmd", "setp", "sampler.0.enable", str(on)], check=True)
        depth = lambda: self.hal.value("sampler.0.curr-depth")
        sample(1)
        self.pass_cycles(AROUND_CYCLES)
        self.wait(lambda: depth() < AROUND_CYCLES, "hand out its samples")
        self.command.mode(linuxcnc.MODE_AUTO)
        self.wait(lambda: status.task_mode == linuxcnc.MODE_AUTO, "take programs")
        start, end = self.hal.joints(), self.task["end"]
        self.command.program_open(str(self.folder / "program.ngc"))
        self.command.auto(linuxcnc.AUTO_RUN, 0)
        self.wait(lambda: status.interp_state != linuxcnc.INTERP_IDLE or self.hal.joints() != start, "begin the program")

        def done():
            idle = status.interp_state == linuxcnc.INTERP_IDLE and status.queue == 0 and status.inpos
            return idle and (end is None or self.is_at(end, 1e-6))

        self.wait(done, "end the program")
        self.rest()
        self.pass_cycles(AROUND_CYCLES)
        sample(0)
        # What is in its store is still to be printed.
        self.wait(lambda: depth() == 0, "hand out its last samples")
        sampler.send_signal(signal.SIGINT)
        sampler.wait(timeout=60)
        text = (self.folder / "rows").read_text()
        if "overrun" in text or self.hal.value("sampler.0.overruns"):
            raise TooSlow("LinuxCNC's sampler lost set-points")
        return [[float(word) for word in line.split()] for line in text.splitlines()]

    def run(self):
        """Switches on, homes, and does the task; the joints asked for."""
        linuxcnc, status, command = self.linuxcnc, self.status, self.command
        for pin, value in self.task["pins"].items():
            subprocess.run(["halcmd", "setp", f"{self.task['kinematics']}.{pin}", str(value)], check=True)
        status.poll()
        for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
            command.state(state)
            self.wait(lambda: status.task_state == state, "switch on")
        command.home(-1)
        self.wait(lambda: all(status.homed[: len(self.places)]), "home")
        command.mode(linuxcnc.MODE_MDI)
        self.wait(lambda: status.task_mode == linuxcnc.MODE_MDI, "take commands")
        joints = [self.go(pose) for pose in self.task["poses"]]
        return self.play() if self.task["program"] else joints


def drive(task, result):
    """Inside LinuxCNC: does the task and writes the joints, or why it could not."""
    # What is left standing if it is stopped from outside, or LinuxCNC takes this program with it.
    Path(result).write_text(json.dumps({"started": True}))
    try:
        answer = {"joints": Session(json.loads(Path(task).read_text()), Path(result).parent).run()}
    except TooSlow as error:
        answer = {"slow": str(error)}
    except Exception as error:
        answer = {"error": f"{type(error).__name__}: {error}"}
    Path(result).write_text(json.dumps(answer))


def python_of_linuxcnc():
    """A Python that has LinuxCNC's module; None without."""
    for python in filter(os.path.exists, (sys.executable, "/usr/bin/python3")):
        # Not from this folder: it has a linuxcnc.py too.
        if subprocess.run([python, "-c", "import linuxcnc"], capture_output=True, cwd="/").returncode == 0:
            return python
    return None


def joints_at(module, poses, python):
    """LinuxCNC's joints at these poses; each has a word for each of the module's axes, in their order."""
    return session(module, poses, "", None, python)


def joints_along(module, start, program, python, end=None):
    """LinuxCNC's joints in every servo cycle (1 ms) of a part program that begins at the pose `start` and, if that is given,
    ends at the pose `end`; at rest for a while before and after."""
    return session(module, [start], program, end, python)


def session(module, poses, program, end, python):
    """Joints after every pose, or those of the program if there is one."""
    # HAL refuses root: it runs as nobody, who may not be able to read this file where it is.
    user = {}
    if os.geteuid() == 0:
        nobody = pwd.getpwnam("nobody")
        user = {"user": nobody.pw_uid, "group": nobody.pw_gid, "extra_groups": []}
    with tempfile.TemporaryDirectory(prefix="seamwright-peer-") as name:
        folder = Path(name)
        display = folder / "display"
        shutil.copy(__file__, folder / "drive.py")
        display.write_text(f"#!/bin/sh\nexec {python} {folder}/drive.py {folder}/task {folder}/result\n")
        display.chmod(0o755)
        write_configuration(folder, module, display)
        (folder / "program.ngc").write_text(program)
        task = {**module, "poses": poses, "program": bool(program), "end": end}
        (folder / "task").write_text(json.dumps(task))
        if user:
            for path in [folder, *folder.iterdir()]:
                shutil.chown(path, user["user"], user["group"])
        # With RUNTESTS set it writes to our log instead of files of its own.
        environment = {"PATH": os.environ["PATH"], "HOME": name, "RUNTESTS": "1", "LANG": "C.UTF-8"}
        with open(folder / "log", "w") as log:
            process = subprocess.Popen(
                ["linuxcnc", str(folder / "peer.ini")], stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                env=environment, start_new_session=True, cwd=name, **user,
            )
            try:
                has_ended = wait_while_alive(process, folder)
            finally:
                clear_up(process, environment, user)
        if not (folder / "result").exists():
            raise NotStarted((folder / "log").read_text()[-2000:])
        answer = json.loads((folder / "result").read_text())
        last_words = (folder / "log").read_text()[-2000:]
    if answer.get("started") and has_ended:
        raise RuntimeError(f"LinuxCNC ended in the session, without an answer: {last_words}")
    if answer.get("started"):
        raise TooSlow(f"LinuxCNC started, and gave no sign for {SILENT_S} s")
    if "slow" in answer:
        raise TooSlow(answer["slow"])
    if "error" in answer:
        raise RuntimeError(answer["error"])
    return answer["joints"]


def wait_while_alive(process, folder):
    """Until it ends, or gives no sign for a long time; True if it ended."""
    signs = lambda: [path.read_text() if path.exists() else "" for path in (folder / "signs", folder / "result")]
    seen, since = signs(), time.monotonic()
    while process.poll() is None and time.monotonic() - since < SILENT_S:
        time.sleep(0.2)
        now = signs()
        if now != seen:
            seen, since = now, time.monotonic()
    return process.poll() is not None


def clear_up(process, environment, user):
    """Ends what is left of a LinuxCNC that did not end by itself; it clears up after itself on SIGTERM."""
    if process.poll() is None:
        os.killpg(process.pid, signal.SIGTERM)
        try:
            process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.wait()
    if process.returncode != 0:
        subprocess.run(["halrun", "-U"], env=environment, capture_output=True, timeout=60, **user)


if __name__ == "__main__":
    drive(*sys.argv[1:])
