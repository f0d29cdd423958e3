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
addf sampler.0 servo-thread\n"""
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


def drive(task, result):
    """Inside LinuxCNC: sends it to every pose, plays the program, and writes its joints, or why it could not."""
    import linuxcnc

    # What is left standing if it is stopped from outside.
    Path(result).write_text(json.dumps({"error": "LinuxCNC started but was not done in time"}))
    task = json.loads(Path(task).read_text())
    places = ["XYZABCUVW".index(axis) for axis in task["axes"]]
    command, status, errors = linuxcnc.command(), linuxcnc.stat(), linuxcnc.error_channel()

    def wait(ready, what, seconds=10):
        deadline = time.monotonic() + seconds
        while not ready():
            message = errors.poll()
            if message or time.monotonic() > deadline:
                raise RuntimeError(f"LinuxCNC does not {what}: {message[1] if message else 'no answer in 10 s'}")
            time.sleep(0.0005)
            status.poll()

    def there(pose):
        return (
            status.echo_serial_number == command.serial and status.state == linuxcnc.RCS_DONE and status.inpos
            and all(abs(status.position[place] - word) < 1e-9 for place, word in zip(places, pose))
        )

    def outputs():
        status.poll()
        return [status.joint[joint]["output"] for joint in range(len(places))]

    def settled():
        before = outputs()
        time.sleep(0.003)
        return before == outputs()

    def go(pose):
        words = " ".join(f"{axis}{word:.9f}" for axis, word in zip(task["axes"], pose))
        command.mdi(f"G53 G0 {words}")
        wait(lambda: there(pose), f"reach {words}")
        wait(settled, "come to rest")
        return outputs()

    def play():
        """Joints in every servo period of the program, and a few at rest around it."""
        rows = Path(result).with_name("rows")
        with open(rows, "w") as file:
            sampler = subprocess.Popen(["halsampler"], stdout=file)
        subprocess.run(["halcmd", "setp", "sampler.0.enable", "1"], check=True)
        time.sleep(0.2)
        command.mode(linuxcnc.MODE_AUTO)
        wait(lambda: status.task_mode == linuxcnc.MODE_AUTO, "take programs")
        command.program_open(str(Path(result).with_name("program.ngc")))
        command.auto(linuxcnc.AUTO_RUN, 0)
        wait(lambda: status.interp_state != linuxcnc.INTERP_IDLE, "begin the program")
        wait(lambda: status.interp_state == linuxcnc.INTERP_IDLE and status.inpos, "end the program", task["seconds"])
        wait(settled, "come to rest")
        time.sleep(0.2)
        sampler.send_signal(signal.SIGINT)
        sampler.wait(timeout=10)
        text = rows.read_text()
        if "overrun" in text:
            raise RuntimeError("LinuxCNC's sampler lost set-points")
        return [[float(word) for word in line.split()] for line in text.splitlines()]

    try:
        for pin, value in task["pins"].items():
            subprocess.run(["halcmd", "setp", f"{task['kinematics']}.{pin}", str(value)], check=True)
        status.poll()
        for state in (linuxcnc.STATE_ESTOP_RESET, linuxcnc.STATE_ON):
            command.state(state)
            wait(lambda: status.task_state == state, "switch on")
        command.home(-1)
        wait(lambda: all(status.homed[: len(places)]), "home")
        command.mode(linuxcnc.MODE_MDI)
        wait(lambda: status.task_mode == linuxcnc.MODE_MDI, "take commands")
        answer = {"joints": [go(pose) for pose in task["poses"]]}
        if task["program"]:
            answer["joints"] = play()
    except Exception as error:
        answer = {"error": str(error)}
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
    return session(module, poses, "", 0.1 * len(poses), python)


def joints_along(module, start, program, seconds, python):
    """LinuxCNC's joints in every servo period (1 ms) of a part program that begins at the pose `start` and takes at most
    `seconds`; at rest for a while before and after."""
    return session(module, [start], program, seconds, python)


def session(module, poses, program, seconds, python):
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
        task = {**module, "poses": poses, "program": bool(program), "seconds": seconds}
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
                process.wait(timeout=30 + seconds)
            except subprocess.TimeoutExpired:
                pass
            finally:
                clear_up(process, environment, user)
        if not (folder / "result").exists():
            raise NotStarted((folder / "log").read_text()[-2000:])
        answer = json.loads((folder / "result").read_text())
    if "error" in answer:
        raise RuntimeError(answer["error"])
    return answer["joints"]


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
