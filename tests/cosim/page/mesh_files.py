"""What the tests of meshes share: an STL file, and a scenario whose robot names such files."""

import re

from report_program import SCENARIOS


def write_part(file, corners):
    """A part of one triangle."""
    vertices = "".join("vertex {} {} {}\n".format(*corner) for corner in corners)
    facet = f"facet normal 0 0 0\nouter loop\n{vertices}endloop\nendfacet\n"
    file.write_text(f"solid part\n{facet}endsolid part\n")


def write_scenario(file, scenario, meshes):
    """A copy of the scenario, without its golden, beside a copy of its robot with these keys of [meshes]."""
    text = (scenario / "scenario.toml").read_text()
    robot = re.search('robot = "(.*)"', text)[1]
    keys = (SCENARIOS / "robots" / f"{robot}.toml").read_text()
    file.with_name(f"{robot}.toml").write_text(f"{keys}\n[meshes]\n{meshes}\n")
    file.write_text(text.replace(f'"{robot}"', f'"{robot}.toml"').partition("[golden]")[0])
