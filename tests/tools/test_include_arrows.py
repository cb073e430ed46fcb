"""The include arrows of the design: who may include whom. Run by CTest; also proves that it can fail."""

import pathlib
import re
import tempfile
import unittest
from collections import Counter

from include_rules import CONTROLLER, COSIM, DESCRIBED, DESCRIPTION, HOST_ONLY, MAX_SOURCES, NESTED, PLANT

ROOT = pathlib.Path(__file__).resolve().parents[2]
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]', re.M)


def includes(path):
    return INCLUDE.findall(path.read_text(encoding="utf-8"))


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in {".hpp", ".cpp", ".h"})


def violations(root):
    found = []
    for path in sources(root / "controller"):
        folder = path.relative_to(root / "controller").parts[0]
        for name in includes(path):
            parts = name.split("/")
            if parts[0] == "controller" and parts[1] != folder and parts[1] not in CONTROLLER.get(folder, set()):
                found.append(f"{path.relative_to(root)}: controller/{folder} must not include {name}")
            elif parts[0] in {"cosim", "tests"} or name.startswith("V") and name.endswith(".h"):
                found.append(f"{path.relative_to(root)}: the controller must not include {name}")
            elif HOST_ONLY.match(name):
                found.append(f"{path.relative_to(root)}: the controller must not use {name}")
    for outer, rules in NESTED.items():
        for path in sources(root / outer):
            folder = path.relative_to(root / outer).parts[0]
            for name in includes(path):
                target = name.removeprefix(f"{outer}/").split("/")[0]
                if name.startswith(f"{outer}/") and target not in rules.get(folder, set()) | {folder}:
                    found.append(f"{path.relative_to(root)}: {outer}/{folder} must not include {name}")
    # Drivers know one block each and never each other.
    for path in sources(root / "controller" / "drivers"):
        for name in includes(path):
            if name.startswith("controller/drivers/") and pathlib.PurePath(name).stem != path.stem:
                found.append(f"{path.relative_to(root)}: a driver must not include another driver ({name})")
    for path in sources(root / "cosim"):
        file = path.relative_to(root / "cosim")
        for name in includes(path):
            if name.startswith("cosim/") and len(file.parts) > 1:
                folder, target = file.parts[0], name.removeprefix("cosim/")
                if target.split("/")[0] not in COSIM.get(folder, set()) | {folder}:
                    found.append(f"{path.relative_to(root)}: cosim/{folder} must not include {name}")
            if name.startswith("tests/"):
                found.append(f"{path.relative_to(root)}: the simulator must not include {name}")
    for path in sources(root / "cosim" / "scenario"):
        for name in includes(path):
            parts = name.split("/")
            if parts[0] == "cosim" and parts[1] in DESCRIBED and not DESCRIPTION.search(name):
                found.append(f"{path.relative_to(root)}: the scenario knows the description of a part only, not {name}")
    for path in sources(root / "cosim" / "plant"):
        for name in includes(path):
            if name.split("/")[0] in {"controller", "cosim"} and not any(name.startswith(ok) for ok in PLANT):
                found.append(f"{path.relative_to(root)}: the plant sees pins only, not {name}")
    model_users = [p for p in sources(root / "cosim") if any(re.match(r"V\w+\.h$", n) for n in includes(p))]
    if len(model_users) != 1 or model_users[0].parent != root / "cosim" / "fabric" or model_users[0].suffix != ".cpp":
        names = [str(p.relative_to(root)) for p in model_users]
        found.append(f"exactly one .cpp of cosim/fabric includes the verilated model, found {names}")
    return found


class IncludeArrows(unittest.TestCase):
    def test_the_tree_has_no_violation(self):
        self.assertEqual(violations(ROOT), [])

    def test_every_controller_folder_has_a_rule(self):
        folders = {p.name for p in (ROOT / "controller").iterdir() if p.is_dir()}
        self.assertLessEqual(folders, set(CONTROLLER))

    def test_every_nested_folder_has_a_rule_and_every_file_a_folder(self):
        for outer, rules in NESTED.items():
            folders = {p.name for p in (ROOT / outer).iterdir() if p.is_dir()}
            self.assertEqual(folders, set(rules), outer)
            self.assertEqual([p.name for p in sources(ROOT / outer) if p.parent == ROOT / outer], [])

    def test_every_cosim_folder_has_a_rule(self):
        folders = {p.name for p in (ROOT / "cosim").iterdir() if p.is_dir()}
        self.assertEqual(folders, set(COSIM))

    def test_no_folder_has_more_sources_than_a_reader_can_hold(self):
        sizes = Counter(
            str(p.parent.relative_to(ROOT)) for part in ("controller", "cosim") for p in sources(ROOT / part)
        )
        self.assertEqual({folder: size for folder, size in sizes.items() if size > MAX_SOURCES}, {})

    def test_the_rules_have_no_cycle(self):
        for rules in (CONTROLLER, COSIM, *NESTED.values()):
            left = dict(rules)
            while left:
                bottom = {folder for folder, below in left.items() if not below & left.keys()}
                self.assertTrue(bottom, f"a cycle among {sorted(left)}")
                left = {folder: below for folder, below in left.items() if folder not in bottom}

    def test_each_kind_of_violation_is_reported(self):
        cases = {
            "controller/base/a.hpp": '#include "controller/hal/register_bus.hpp"',
            "controller/motion/b.cpp": '#include "controller/activity/move_checks.hpp"',
            "controller/trajectory/path/n.hpp": '#include "controller/trajectory/joint/joint_move.hpp"',
            "controller/language/gcode/reader/s.cpp": '#include "controller/language/gcode/execute/executor.hpp"',
            "controller/motion/c.cpp": '#include "controller/regs/encoder_regs.hpp"',
            "controller/drivers/encoder.cpp": '#include "controller/drivers/axi_timer.hpp"',
            "controller/app/d.cpp": "#include <iostream>",
            "controller/app/e.cpp": '#include "cosim/time/clock.hpp"',
            "cosim/plant/f.cpp": '#include "controller/regs/encoder_regs.hpp"',
            "cosim/kernel/g.cpp": "#include <Varm_soc.h>",
            "cosim/scenario/i.cpp": '#include "cosim/trace/trace_row.hpp"',
            "cosim/scenario/s.hpp": '#include "cosim/cpu/processor.hpp"',
            "cosim/cpu/t.hpp": '#include "cosim/scenario/scenario.hpp"',
            "cosim/text/j.hpp": '#include "cosim/scenario/scenario.hpp"',
            "cosim/report/k.cpp": '#include "cosim/kernel/simulation.hpp"',
            "cosim/report/judge/o.cpp": '#include "cosim/report/format/junit.hpp"',
            "cosim/report/measure/p.hpp": '#include "cosim/report/facts/fact.hpp"',
            "cosim/time/clock.hpp": '#include "cosim/kernel/script/script.hpp"',
            "cosim/run/q.hpp": '#include "cosim/cli/run/scenario_run.hpp"',
            "cosim/kernel/r.cpp": '#include "cosim/run/run.hpp"',
            "cosim/serve/m.cpp": '#include "cosim/kernel/simulation.hpp"',
            "cosim/unknown/l.hpp": '#include "cosim/text/names.hpp"',
            "cosim/cli/h.cpp": '#include "tests/support/x.hpp"',
        }
        for name, text in cases.items():
            with self.subTest(name), tempfile.TemporaryDirectory() as folder:
                root = pathlib.Path(folder)
                good = {"cosim/fabric/verilated_fabric.cpp": "#include <Varm_soc.h>", name: text}
                for file, content in good.items():
                    (root / file).parent.mkdir(parents=True, exist_ok=True)
                    (root / file).write_text(content + "\n")
                self.assertEqual(len(violations(root)), 1, violations(root))


# Two types of one name in one namespace: the linker takes the functions of one of them for both. A specialisation of a
# template is a type of its own, named with its arguments.
ARGUMENTS = r"<(?:[^<>;{]|<[^<>;{]*>)*>"
TYPE = re.compile(rf"^(?:struct|class|enum class|enum)\s+(\w+(?:::\w+)*(?:{ARGUMENTS})?)[^;{{]*\{{", re.M)
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.M)


def types_of_two_headers(root):
    """Type -> the headers that define it, of those that several headers define in one namespace."""
    headers = {}
    for path in sorted([*root.glob("controller/**/*.hpp"), *root.glob("cosim/**/*.hpp")]):
        text = path.read_text(encoding="utf-8")
        namespace = NAMESPACE.search(text)
        for name in set(TYPE.findall(text)):
            full_name = f"{namespace.group(1) if namespace else ''}::{name}"
            headers.setdefault(full_name, []).append(str(path.relative_to(root)))
    return {name: found for name, found in headers.items() if len(found) > 1}


class TypeNames(unittest.TestCase):
    def test_no_two_headers_define_a_type_of_one_name(self):
        self.assertEqual(types_of_two_headers(ROOT), {})

    def test_a_second_definition_is_found(self):
        with tempfile.TemporaryDirectory() as scratch:
            root = pathlib.Path(scratch)
            for name in ("cosim/a/row.hpp", "cosim/b/row.hpp"):
                (root / name).parent.mkdir(parents=True)
                (root / name).write_text("namespace armature::cosim {\nclass Row final : public Base {\n};\n}\n")
            self.assertEqual(
                types_of_two_headers(root), {"armature::cosim::Row": ["cosim/a/row.hpp", "cosim/b/row.hpp"]}
            )

    def test_specialisations_differ_by_their_arguments(self):
        with tempfile.TemporaryDirectory() as scratch:
            root = pathlib.Path(scratch)
            for name, arguments in (("a", "int"), ("b", "std::array<int, 2>"), ("c", "int")):
                (root / f"cosim/{name}").mkdir(parents=True)
                text = f"namespace armature::cosim {{\ntemplate <>\nstruct Fields<{arguments}> : Plain<6> {{}};\n}}\n"
                (root / f"cosim/{name}/fields.hpp").write_text(text)
            self.assertEqual(
                types_of_two_headers(root),
                {"armature::cosim::Fields<int>": ["cosim/a/fields.hpp", "cosim/c/fields.hpp"]},
            )


if __name__ == "__main__":
    unittest.main()
