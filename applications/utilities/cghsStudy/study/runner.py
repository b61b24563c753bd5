# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     Runs what a study asks for, one run after the other. A run that is killed
#     goes on from the last time that it has written whole; one that fails keeps
#     its reason, and the others go on.
# ------------------------------------------------------------------------------
"""Running and resuming."""

import shlex
import subprocess
import time

import runLog
from study.runFolder import (
    ABSENT, FAILED, FINISHED, STALE, UNFINISHED, RunFolder)

POLL = 0.2      # [s] between looks at a run
REPORT = 10     # [s] between lines on how it gets on


class RunFailed(Exception):
    """With the reason, for the report."""


def say(text):
    print(text, flush=True)


def reason_of(text, status):
    """Why a program has failed, by its log: its FATAL error, or its last
    line."""
    found = runLog.fatal_error(text)
    lines = [line for line in text.splitlines() if line.strip()]
    last = lines[-1].strip() if lines else "it wrote nothing"
    return f"{found or last} (exit status {status})"


class Runner:
    """With so many ranks, until the deadline on time.monotonic()."""

    def __init__(self, study, ranks=1, deadline=float("inf")):
        self.study, self.ranks, self.deadline = study, ranks, deadline
        self.process, self.ran = None, False

    def is_late(self):
        return time.monotonic() >= self.deadline

    def run_all(self):
        """Was all that could be run? Every call gets on by one written time at
        least, however early its deadline is."""
        for variant, replica in self.study.pairs():
            run = RunFolder(self.study, variant, replica)
            state, reason = run.state()
            if state in (FINISHED, FAILED):
                hint = (f"; to try again remove {run.path}"
                        if state == FAILED else "")
                say(f"{run.name}: {state} before"
                    + (f": {reason}" if reason else "") + hint)
                continue
            if self.ran and self.is_late():
                return False
            self.carry_on(run, state, reason)
            if run.note()["status"] == UNFINISHED:
                return False
        return True

    def carry_on(self, run, state, reason):
        """One run, whatever becomes of it."""
        if state in (ABSENT, STALE):
            if state == STALE:
                say(f"{run.name}: stale ({reason}): it is run anew, what was"
                    f" there is kept as {run.path}.stale")
            run.create(self.ranks)
        try:
            self._prepare(run)
            self._solve(run)
        except RunFailed as error:
            run.write_note(status=FAILED, reason=str(error))
            say(f"{run.name}: FAILED: {error}")
        except BaseException:
            self._end_process()
            raise

    # Before the solver

    def _prepare(self, run):
        if run.note()["prepared"]:
            return
        commands = list(self.study.prepare)
        if run.note()["ranks"] > 1:
            commands.append("decomposePar -force")
        for command in commands:
            self._apply(run, command)
        run.write_note(prepared=True)

    @staticmethod
    def _apply(run, command):
        words = shlex.split(command)
        log = run.path / f"log.{words[0].split('/')[-1]}"
        try:
            with open(log, "w") as out:
                status = subprocess.run(
                    words, cwd=run.path, stdout=out, stderr=subprocess.STDOUT,
                    stdin=subprocess.DEVNULL, check=False).returncode
        except OSError as error:
            raise RunFailed(f"{command}: {error.strerror}") from None
        if status:
            text = log.read_text(errors="replace")
            raise RunFailed(f"{words[0]}: {reason_of(text, status)}")

    # The solver

    def _solve(self, run):
        run.drop_half_written()
        run.renew_control()
        end = run.end_time()
        stop = run.path / "stop"
        stop.unlink(missing_ok=True)
        self.ran = True
        status = self._watch(run, stop, end)
        stop.unlink(missing_ok=True)
        if status:
            raise RunFailed(reason_of(run.log_text(), status))
        paused = self.is_late() and run.was_asked_to_stop()
        run.write_note(status=UNFINISHED if paused else FINISHED, endTime=end)
        say(f"{run.name}: {'paused' if paused else 'finished'} at t ="
            f" {run.reached():g} s")

    def _watch(self, run, stop, end):
        """The solver's exit status. Past the deadline the file stop asks it to
        end with the next time that it writes."""
        words = shlex.split(self.study.command)
        ranks = run.note()["ranks"]
        if ranks > 1:
            words = ["mpirun", "-np", str(ranks), *words, "-parallel"]
        say(f"{run.name}: {' '.join(words)} from t = {run.reached():g} s"
            + (f" to {end:g} s" if end is not None else ""))
        began = shown = time.monotonic()
        try:
            with open(run.log, "a") as out:
                self.process = subprocess.Popen(
                    words, cwd=run.path, stdout=out, stderr=subprocess.STDOUT,
                    stdin=subprocess.DEVNULL)
        except OSError as error:
            raise RunFailed(f"{words[0]}: {error.strerror}") from None
        while self.process.poll() is None:
            # Often, as the solver takes no heed of a file from before it began
            time.sleep(POLL)
            now = time.monotonic()
            if now - began > 3600*self.study.longest:
                self._end_process()
                raise RunFailed("it took longer than hoursPerRun,"
                                f" {self.study.longest:g} h, to t ="
                                f" {run.reached():g} s")
            if self.is_late():
                stop.touch()
            if now - shown > REPORT:
                shown = now
                self._show(run)
        return self.process.returncode

    @staticmethod
    def _show(run):
        with open(run.log, "rb") as log:
            log.seek(0, 2)
            log.seek(max(log.tell() - 20000, 0))
            tail = log.read().decode(errors="replace")
        lines = [line for line in tail.splitlines()
                 if line.startswith(("Time = ", "progress "))]
        say(f"{run.name}: " + ", ".join(lines[-2:]))

    def _end_process(self):
        if self.process and self.process.poll() is None:
            self.process.terminate()
            try:
                self.process.wait(20)
            except subprocess.TimeoutExpired:
                self.process.kill()
                self.process.wait()
