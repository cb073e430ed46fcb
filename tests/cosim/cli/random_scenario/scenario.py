"""A whole scenario: all tables in their order."""

from .conveyor import put_conveyor, put_policy
from .draft import Draft
from .expect import put_expect
from .machine import put_machine, put_places, put_run, put_solver
from .moves import put_move, put_move_to_ready
from .pendant import put_pendant
from .program import put_program_tables
from .surroundings import put_fault, put_inputs, put_later_fault, put_serial, put_stream


def draw(rng, robots):
    """A Draft that is complete."""
    draft = Draft(rng, robots)
    put_run(draft)
    put_machine(draft)
    draft.table("trace")
    draft.maybe("every_ticks", lambda: draft.integer(1, 40))
    if draft.robot.has_kinematics:
        draft.maybe("tcp", lambda: rng.random() < 0.5)
    put_places(draft)
    put_conveyor(draft)
    put_program_tables(draft)
    if rng.random() < 0.5:
        put_move_to_ready(draft)
    for _ in range(rng.choice([0, 1, 2, 3, 5, 8, 20])):
        put_move(draft)
    put_stream(draft)
    for _ in range(rng.choice([0, 0, 0, 0, 1, 2, 5])):
        put_fault(draft)
    put_inputs(draft)
    put_serial(draft)
    put_pendant(draft)
    put_expect(draft)
    put_solver(draft)
    if rng.random() < 0.05:
        draft.table("golden")
        draft.put("sha256", "0123456789abcdef" * 4)
    put_later_fault(draft)
    put_policy(draft)
    return draft
