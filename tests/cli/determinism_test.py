"""The same scenario gives the same trace, byte for byte: on every run and in every kind of build. The hashes change when
the behaviour does; then they are replaced by what the failing test prints."""
import hashlib
import os
import pathlib

from harness import *

ROOT = pathlib.Path(__file__).resolve().parents[2]
RUNS = 2 if os.environ.get("MERKER_BUILD") == "Debug" else 20
CASES = {
    "examples/sorting-plant": (["--watch", "E 0.0, E 0.1, E 0.2, A 1.0, A 1.1, A 1.2, T 1, T 10, T 20"],
                               "afa624f07a8d4fd0c57b19887a7e422e0ef2c5578c52d61b055388dff13c1367"),
    "tests/scenario/interrupts": (["--watch", "M 200.0, M 200.5, MW 20, MW 40"], "da56a9b6eec36c8d99aa5ee75b09f69ce95e77c51efdecc015749159a05d2bd5"),
}


class Determinism(Case):
    def trace(self, project, arguments):
        self.expect(GOOD, "run", str(ROOT / project), "--for", "10s", *arguments, "--trace", "trace.csv")
        return hashlib.sha256((pathlib.Path(self.folder) / "trace.csv").read_bytes()).hexdigest()

    def test_the_same_trace_on_every_run(self):
        for project, (arguments, expected) in CASES.items():
            with self.subTest(project):
                self.assertEqual({self.trace(project, arguments) for _ in range(RUNS)}, {expected})

    # CNT-SIM-01, CNT-SIM-03, PID-SIM-01, PID-SIM-02: plants and channels in virtual time, with both engines.
    def test_plants_and_channels_move_the_same_on_every_run(self):
        for project, watched in (("temperature-control", "DB41.LMN, DB41.PV, A 124.0, plant Furnace.PV"),
                                 ("cascade-control", "DB41.LMN, A 124.0, A 124.1, plant Heater.PV, plant Valve.POSITION"),
                                 ("pwm-heater", "MW 10, plant Plate.HEAT, plant Plate.PV")):
            arguments = ["--set", "E 125.0 = 1, MW 10 = 300", "--watch", watched]
            with self.subTest(project):
                traces = {self.trace(f"examples/technology/{project}", [*arguments, "--engine", engine])
                          for engine in ("interpreter", "jit", "interpreter", "jit")}
                self.assertEqual(len(traces), 1)
                self.assertGreater(len(self.read("trace.csv").splitlines()), 20)
