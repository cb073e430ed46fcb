"""An environment with the methods of Gymnasium, which need not be installed: the joints reach a target."""

import numpy

from . import STATES, Run, Scenario

FAULT = STATES.index("fault")


class Box:
    """Arrays between two bounds: what Gymnasium's Box offers to those who only draw and check."""

    def __init__(self, low, high):
        self.low = numpy.asarray(low, dtype=numpy.float64)
        self.high = numpy.asarray(high, dtype=numpy.float64)
        self.shape = self.low.shape
        self.dtype = self.low.dtype
        self._random = numpy.random.default_rng()

    def seed(self, seed=None):
        self._random = numpy.random.default_rng(seed)

    def sample(self):
        return self._random.uniform(self.low, self.high)

    def contains(self, values):
        values = numpy.asarray(values)
        return values.shape == self.shape and bool(numpy.all((values >= self.low) & (values <= self.high)))


class ArmEnv:
    """Joint speeds as actions, one for each step; the controller keeps every limit of the arm.

    observation  joint angles by the encoders, set-points, and the target [deg]
    action       speed of each joint [deg/s]; the controller limits it
    reward       minus the largest distance of a joint from its target [deg]; a subclass may override it
    terminated   the joints have reached the target, or the drives are off by a fault
    truncated    the run is over, or `max_steps` have passed

    The scenario should have no moves of its own: ArmEnv("scenarios/jog", set=["move=[]", "expect={}", "duration_s=10"]).
    reset(seed=...) gives the seed to the noise of the scenario and draws the target, within `reach_deg` of 0 and the limits
    of the joints. Without a seed the next one is drawn from the generator that the last seed began.
    """

    START_MS = 10.0  # the drives are on, and the arm takes commands
    metadata = {"render_modes": []}
    render_mode = None

    def __init__(self, where, *, set=(), engine="model", search=(), step_ms=1.0, max_steps=1000, reach_deg=20.0,
                 tolerance_deg=0.05):  # fmt: skip
        self.scenario = Scenario(where, set=list(set), engine=engine, search=list(search))
        self.step_ms, self.max_steps, self.tolerance_deg = step_ms, max_steps, tolerance_deg
        axes = self.scenario.axes
        low, high = (numpy.array([axis[key] for axis in axes]) for key in ("min_deg", "max_deg"))
        speed = numpy.array([axis["max_speed_deg_s"] for axis in axes])
        self.axes = len(axes)
        self.action_space = Box(-speed, speed)
        self.observation_space = Box(numpy.full(3 * self.axes, -numpy.inf), numpy.full(3 * self.axes, numpy.inf))
        self.target_space = Box(numpy.maximum(low, -reach_deg), numpy.minimum(high, reach_deg))
        self._random = numpy.random.default_rng()
        self.run = None

    @property
    def unwrapped(self):
        return self

    def reset(self, *, seed=None, options=None):
        """options: {"target_deg": angles} instead of a drawn target."""
        if seed is not None:
            self._random = numpy.random.default_rng(seed)
        noise = int(self._random.integers(1, 2**31))
        drawn = self._random.uniform(self.target_space.low, self.target_space.high)
        self.target_deg = numpy.array((options or {}).get("target_deg", drawn), dtype=numpy.float64)
        self.run = Run(self.scenario, seed=noise)
        self.steps = 0
        self.run.advance(self.START_MS)
        return self._observation(), self._info()

    def step(self, action):
        # A velocity lasts for two steps, so that the next one replaces it while it still applies.
        self.run.jog(action, 2e-3 * self.step_ms)
        goes_on = self.run.advance(self.step_ms)
        self.steps += 1
        observation = self._observation()
        faulted = self.run.trace("state")[-1] == FAULT
        terminated = bool(faulted or self.distance_deg(observation) <= self.tolerance_deg)
        truncated = not goes_on or self.steps >= self.max_steps
        return observation, self.reward(observation, action), terminated, truncated, self._info()

    def reward(self, observation, action):
        return -float(self.distance_deg(observation))

    def distance_deg(self, observation):
        return numpy.abs(observation[: self.axes] - observation[2 * self.axes :]).max()

    def render(self):
        return None

    def close(self):
        self.run = None

    def _observation(self):
        encoders, set_points = (self.run.trace(column)[-1, : self.axes] for column in ("enc_deg", "ref_deg"))
        return numpy.concatenate((encoders, set_points, self.target_deg))

    def _info(self):
        return {"time_s": self.run.time_s, "refused": self.run.refused}
