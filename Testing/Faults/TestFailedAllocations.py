# SPDX-License-Identifier: BSD-3-Clause
"""One allocation fails, in any thread, or all from one on: there must be no wrong file with exit 0, no hang
and no leftover file.

Most allocations of a run are small and made by libraries. Those of more than LEAST bytes are the buffers of
the results, and get half of the faults.
"""
from Faults import RUNS, Fault, FaultTest, Tally, report, rounds, run_all
import Program

LEAST = 16 * 1024

# One of so many faults lasts, as if the memory were full.
LASTING = 0.25


class FailedAllocations(FaultTest):
    def inject(self, least, count):
        cases = self.cases(least=least)
        plan = [(case, Fault(kind, number, "ENOMEM", self.rng.random() < LASTING, least))
                for case, kind, number in rounds(cases, ["allocate"], count, self.rng)]
        tally = Tally()
        run_all(plan, tally)
        report(self, tally)

    def test_buffers(self):
        self.inject(LEAST, RUNS - RUNS // 2)

    def test_any_size(self):
        self.inject(0, RUNS // 2)


if __name__ == "__main__":
    Program.main()
