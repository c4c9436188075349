# SPDX-License-Identifier: BSD-3-Clause
"""One system call fails, or all from one on: there must be no wrong file with exit 0, no hang and no
leftover file."""
from Faults import ERRORS, KINDS, RUNS, Fault, FaultTest, Tally, report, rounds, run_all
import Program

# One of so many faults lasts, like a full disk or a limit on threads.
LASTING = 0.25


class FailedCalls(FaultTest):
    def test_any_call(self):
        cases = self.cases()
        kinds = [kind for kind in KINDS if kind != "allocate"]
        plan = []
        for case, kind, number in rounds(cases, kinds, RUNS, self.rng):
            error = self.rng.choice(ERRORS[kind])
            # An interrupted call is repeated, so no system interrupts all calls.
            lasting = self.rng.random() < LASTING and error != "EINTR"
            plan.append((case, Fault(kind, number, error, lasting)))
        tally = Tally()
        run_all(plan, tally)
        report(self, tally)

    def test_no_thread_at_all(self):
        cases = [case for case in self.cases() if case.calls["thread"] > 0]
        tally = Tally()
        run_all([(case, Fault("thread", 1, "EAGAIN", True)) for case in cases], tally)
        report(self, tally)
        images = [case for case in cases if case.images]
        self.assertEqual(tally.verdicts, {"right": len(cases) - len(images), "refused": len(images)},
                         "one thread is enough for all work but images")


if __name__ == "__main__":
    Program.main()
