"""Reads the simulated Universal Robots control by `ur-rtde`, a client of others.

Our RTDE client is tested against our simulated control; that this control speaks RTDE is checked here.
Usage: ur_rtde.py ROBOT_CONTROL (the example of seamwright-simulation)
"""

import math
import subprocess
import sys
import time

from rtde_receive import RTDEReceiveInterface

DEGREES = [10.0, -80.0, 70.0, -60.0, 50.0, -40.0]
FIELDS = ["timestamp", "actual_q", "robot_mode", "safety_mode", "runtime_state"]


def main() -> int:
    angles = [str(angle) for angle in DEGREES]
    control = subprocess.Popen([sys.argv[1], "rtde", "127.0.0.1:30004", "20", *angles], stdout=subprocess.DEVNULL)
    try:
        time.sleep(0.5)
        client = RTDEReceiveInterface("127.0.0.1", 500.0, FIELDS)
        time.sleep(0.5)
        off = max(abs(math.degrees(q) - angle) for q, angle in zip(client.getActualQ(), DEGREES))
        begun, wall = client.getTimestamp(), time.monotonic()
        time.sleep(2.0)
        rate = (client.getTimestamp() - begun) / (time.monotonic() - wall)
        modes = client.getRobotMode(), client.getSafetyMode(), client.getRuntimeState()
        client.disconnect()
    finally:
        control.kill()
        control.wait()
    print(f"ur-rtde reads the simulated control: positions off by {off:.1e} degrees, clock at {rate:.3f}, modes {modes}")
    good = off < 1e-9 and abs(rate - 1.0) < 0.05 and modes == (7, 1, 2)
    if not good:
        print("FAILED: ur-rtde reads something else than the simulated control sends", file=sys.stderr)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
