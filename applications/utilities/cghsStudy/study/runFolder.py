# ------------------------------------------------------------------------------
# cghsFoam: coarse-grained hard-sphere fluidised beds for OpenFOAM
# Licence: GPL-3.0-or-later, see the file LICENSE
#
# Description
#     The folder of one run: its inputs, in what state it is, what has to be
#     taken from it before it can go on. Nothing is run here.
#
#     What a run was made from is kept in study.json beside it: a check sum of
#     each input, and the commands. If the case or the dictionary makes others
#     now, the run is stale: its results are those of another variant. A later
#     endTime makes no run stale, it goes on.
# ------------------------------------------------------------------------------
"""Folders of runs, and their states."""

import gzip
import hashlib
import json
import shutil
from functools import cached_property

import caseFiles
import runLog
from study.dictionary import find, set_entry
from study.settings import CONTROL
from study.studyError import StudyError

NOTE = "study.json"

# In what state a run may be
ABSENT, STALE, UNFINISHED, FINISHED, FAILED = (
    "absent", "stale", "unfinished", "finished", "failed")

# Asks a run to end with the next time that it writes
STOP = """
// Written by cghsStudy, for its option -hours
functions
{
    cghsStudyStop
    {
        type    abort;
        libs    (utilityFunctionObjects);
        file    "<case>/stop";
        action  nextWrite;
    }
}
"""

DECOMPOSITION = """
// Written by cghsStudy, for its option -np
numberOfSubdomains  {ranks};
method              scotch;
"""


def check_sum(data):
    return hashlib.sha256(data).hexdigest()


def is_whole(path):
    """OpenFOAM ends its files with a line of comment. One that was killed while
    it wrote leaves some without."""
    data = path.read_bytes()
    if path.suffix == ".gz":
        try:
            data = gzip.decompress(data)
        except (OSError, EOFError):
            return False
    return data.rstrip().endswith(b"//")


class RunFolder:
    """A replica of a variant."""

    def __init__(self, study, variant, replica):
        self.study, self.variant, self.replica = study, variant, replica
        self.path = study.folder / variant / str(replica)
        self.name = f"{variant}/{replica}"
        self.log = self.path / f"log.{study.command.split()[0].split('/')[-1]}"

    # Inputs

    @cached_property
    def inputs(self):
        """Contents by names, with the settings of the variant."""
        files = dict(self.study.files)
        for setting in self.study.settings(self.variant, self.replica):
            if setting.file not in files:
                raise StudyError(
                    *setting.why, f"the case has no file {setting.file}",
                    sorted(f for f in files if "polyMesh" not in f))
            files[setting.file] = set_entry(
                files[setting.file].decode(), setting.file, setting.entry,
                setting.value, setting.why).encode()
        return files

    def _sums(self, files):
        """What must not change; that endTime may."""
        text = files[CONTROL].decode()
        if "endTime" in text:
            why = self.study.block.file, None
            text = set_entry(text, CONTROL, "endTime", "any", why)
        sums = {name: check_sum(data) for name, data in files.items()}
        return {**sums, CONTROL: check_sum(text.encode())}

    def _commands(self):
        return [*self.study.prepare, self.study.command]

    def _for_running(self, files, ranks):
        """What is added to the inputs so that a run can be broken off, go on
        and have ranks."""
        text = files[CONTROL].decode()
        why = self.study.block.file, None
        text = set_entry(text, CONTROL, "startFrom", "latestTime", why)
        files = {**files, CONTROL: (text + STOP).encode()}
        if ranks > 1:
            name = "system/decomposeParDict"
            files[name] = files.get(name, HEADER) + DECOMPOSITION.format(
                ranks=ranks).encode()
        return files

    # The note

    def note(self):
        try:
            return json.loads((self.path / NOTE).read_text())
        except (OSError, ValueError):
            return {}

    def write_note(self, **changes):
        text = json.dumps({**self.note(), **changes}, indent=1)
        new = self.path / f"{NOTE}.new"
        new.write_text(text + "\n")
        new.replace(self.path / NOTE)

    # State

    def end_time(self):
        """That the variant names, or none where it has no endTime."""
        text = self.inputs[CONTROL].decode()
        if "endTime" not in text:
            return None
        entry = find(text, CONTROL, "endTime", (self.study.block.file, None))
        return float(text[entry.start:entry.end])

    def state(self):
        """And why it is so."""
        note = self.note()
        if not note:
            return ABSENT, ""
        changed = self.changes(note)
        if changed:
            return STALE, "other than now: " + ", ".join(changed)
        if note["status"] == FINISHED and self._is_to_be_longer(note):
            return UNFINISHED, "endTime is later now"
        return note["status"], note.get("reason", "")

    def _is_to_be_longer(self, note):
        end = self.end_time()
        return (end is not None and note.get("endTime") is not None
                and end > note["endTime"]*(1 + 1e-9))

    def changes(self, note):
        """Names of what is not as it was."""
        now = self._sums(self.inputs)
        names = [name for name in sorted({*now, *note["inputs"]})
                 if now.get(name) != note["inputs"].get(name)]
        if note["commands"] != self._commands():
            names.append("prepare or run")
        return names

    # Making it ready

    def create(self, ranks):
        """A new folder, in which nothing has been run. What is stale is kept
        under another name, until the next that is."""
        if self.path.exists():
            old = self.path.with_name(self.path.name + ".stale")
            shutil.rmtree(old, ignore_errors=True)
            self.path.rename(old)
        files = self.inputs
        self._write(self._for_running(files, ranks))
        self.write_note(
            status=UNFINISHED, reason="", prepared=False, ranks=ranks,
            inputs=self._sums(files), commands=self._commands())

    def _write(self, files):
        for name, data in files.items():
            path = self.path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(data)
            if name in self.study.copied:
                path.chmod((self.study.case / name).stat().st_mode)

    def renew_control(self):
        """Of a run that goes on, as endTime may have changed."""
        files = self._for_running(self.inputs, 1)
        self._write({CONTROL: files[CONTROL]})

    def drop_half_written(self):
        """Times after a last one that is whole in all ranks; all files of the
        one before have to be there and have an end."""
        while True:
            times = [t for t in caseFiles.times(self.path) if float(t) > 0]
            if not times or self._is_complete(times[-1], times[:-1]):
                return
            for folder in self._places(times[-1]):
                shutil.rmtree(folder)

    def _places(self, time):
        return [folder / time for folder in
                (self.path, *self.path.glob("processor[0-9]*"))
                if (folder / time).is_dir()]

    def _is_complete(self, time, earlier):
        ranks = sorted(self.path.glob("processor[0-9]*"))
        for place in ranks or [self.path]:
            now = self._files(place / time)
            before = self._files(place / earlier[-1]) if earlier else {}
            if not now or set(before) - set(now):
                return False
            if not all(is_whole(path) for path in now.values()):
                return False
        return True

    @staticmethod
    def _files(folder):
        """By names without .gz."""
        return {str(path.relative_to(folder)).removesuffix(".gz"): path
                for path in folder.rglob("*") if path.is_file()}

    def was_asked_to_stop(self):
        """Did its last start end early, by the file stop?"""
        return "USER REQUESTED ABORT" in runLog.starts(self.log_text())[-1]

    def reached(self):
        times = caseFiles.times(self.path) if self.path.exists() else []
        return float(times[-1]) if times else 0.0

    def log_text(self):
        try:
            return self.log.read_text(errors="replace")
        except OSError:
            return ""


HEADER = b"""FoamFile
{
    version     2.0;
    format      ascii;
    class       dictionary;
    object      decomposeParDict;
}
"""
