"""The robots of random scenarios."""

import tomllib

# The nominal stands of the arms, from which short Cartesian moves are possible [deg].
READY = {
    "vo2021_6r": [0, 20, -30, 0, 45, 0],
    "abb_irb120": [0, 0, 0, 0, 90, 0],
    "kuka_kr6_r900": [0, -90, 90, 0, 30, 0],
    "fanuc_lrmate200id": [0, 0, 0, 0, -90, 0],
    "hu2012_5r": [0, -90, 0, -90, 0],
}


class Robot:
    def __init__(self, folder, name):
        self.name = name
        spec = tomllib.loads((folder / f"{name}.toml").read_text())
        self.axes = len(spec["axis"])
        self.has_kinematics = "kinematics" in spec
        defaults = spec.get("defaults", {})
        self.can_home = all("homing" in axis or "homing" in defaults for axis in spec["axis"])
        self.has_jerk = all("max_jerk_deg_s3" in axis or "max_jerk_deg_s3" in defaults for axis in spec["axis"])
