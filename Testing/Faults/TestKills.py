# SPDX-License-Identifier: BSD-3-Clause
"""The process is killed or interrupted, at a call or at any moment: the old file or the new one, whole,
and no litter after the next run."""
import signal
import subprocess
import time

import Faults
import Program
from Faults import RUNS, Fault, FaultTest, Tally, report, rounds, run_all

# Seconds from an interrupt to the end: 1 on a machine that is not busy, which one of CI may be.
SOON = 3.0

# Calls that change files: a kill at these is most likely to leave something.
CHANGES = ["open", "write", "close", "sync", "rename", "remove", "truncate", "mode"]

INTERRUPTS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT]


class Kills(FaultTest):
    def run_at_moments(self, cases, count, signals, tally, patience):
        for k in range(count):
            case = cases[k % len(cases)]
            moment = self.rng.uniform(0.0, 1.1 * case.seconds)
            number = self.rng.choice(signals)
            running = case.start(Fault())
            time.sleep(moment)
            sent = time.monotonic()
            running.send_signal(number)
            try:
                out, said = running.communicate(timeout=Faults.PATIENCE)
                verdict = case.judge(running.returncode, out, said, killed=True)
            except subprocess.TimeoutExpired:
                running.kill()
                out, said = running.communicate()
                verdict = "HUNG"
            seconds = time.monotonic() - sent
            if seconds > patience:
                verdict = "HUNG"
            tally.add(case, "signal %d after %.3f s, ended %.2f s later" % (number, moment, seconds),
                      verdict, said.decode(errors="replace"), seconds)

    def sweep(self, cases, tally):
        for case in cases:
            tally.findings += case.sweep()

    def test_kill_at_calls(self):
        cases = self.cases()
        plan = [(case, Fault(kind, number, "signal %d" % signal.SIGKILL))
                for case, kind, number in rounds(cases, CHANGES, RUNS - RUNS // 2, self.rng)]
        tally = Tally()
        run_all(plan, tally)
        report(self, tally)

    def test_kill_at_moments(self):
        cases = self.cases()
        for case in cases:
            case.clear()
        tally = Tally()
        self.run_at_moments(cases, RUNS // 2, [signal.SIGKILL], tally, Faults.PATIENCE)
        self.sweep(cases, tally)
        report(self, tally)

    def test_interrupt_at_moments(self):
        cases = self.cases()
        for case in cases:
            case.clear()
        tally = Tally()
        self.run_at_moments(cases, RUNS // 2, INTERRUPTS, tally, SOON)
        for case in cases:
            if case.litter():
                tally.findings.append("%s: LITTER after interrupts: %s" % (case.name, case.litter()))
        self.sweep(cases, tally)
        report(self, tally)


if __name__ == "__main__":
    Program.main()
