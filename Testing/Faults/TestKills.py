# SPDX-License-Identifier: BSD-3-Clause
"""The process is killed or interrupted, at a call or at any time. The old file or the new one must be
complete, and the next run must leave no other files. An interrupt must leave none itself and end the
process at once."""
import signal
import subprocess
import time

from Faults import PATIENCE, RUNS, Fault, FaultTest, Tally, report, rounds, run_all
import Program

# Seconds from an interrupt to the end: 1 on an idle machine, more on a busy one.
SOON = 3.0

# Calls that change files: a kill at one of them is most likely to leave a file.
CHANGES = ["open", "write", "close", "sync", "rename", "remove", "truncate", "mode"]

INTERRUPTS = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGQUIT, signal.SIGPIPE]

# Before this part of the run time, the program is only being loaded.
LOADED = 0.4


class Kills(FaultTest):
    def at_calls(self, kinds, signals, count, patience):
        """Sends a signal at a call."""
        plan = [(case, Fault(kind, number, "signal %d" % self.rng.choice(signals)))
                for case, kind, number in rounds(self.cases(), kinds, count, self.rng)]
        tally = Tally(patience)
        run_all(plan, tally, clean=signal.SIGKILL not in signals)
        report(self, tally)

    def at_moments(self, signals, count, patience):
        """Sends a signal from outside, at any time of the run."""
        cases = self.cases()
        for case in cases:
            case.clear()
        tally = Tally(patience)
        for k in range(count):
            case = cases[k % len(cases)]
            moment = case.seconds * self.rng.uniform(LOADED, 1.1)
            number = self.rng.choice(signals)
            running = case.start(Fault())
            time.sleep(moment)
            sent = time.monotonic()
            running.send_signal(number)
            try:
                out, said = running.communicate(timeout=PATIENCE)
                verdict = case.judge(running.returncode, out, said, killed=True)
            except subprocess.TimeoutExpired:
                running.kill()
                out, said = running.communicate()
                verdict = "HUNG"
            tally.add(case, "signal %d after %.3f s" % (number, moment), verdict,
                      said.decode(errors="replace"), time.monotonic() - sent)
        for case in cases:
            if signal.SIGKILL not in signals:
                tally.findings += case.left_over("after interrupts")
            tally.findings += case.sweep()
        report(self, tally)

    def test_kill_at_calls(self):
        self.at_calls(CHANGES, [signal.SIGKILL], RUNS - RUNS // 2, PATIENCE)

    def test_kill_at_moments(self):
        self.at_moments([signal.SIGKILL], RUNS // 2, PATIENCE)

    def test_interrupt_at_calls(self):
        self.at_calls(CHANGES + ["read", "thread", "map"], INTERRUPTS, RUNS - RUNS // 2, SOON)

    def test_interrupt_at_moments(self):
        self.at_moments(INTERRUPTS, RUNS // 2, SOON)


if __name__ == "__main__":
    Program.main()
