"""
This part of the workflow lets a build begin after another one was killed, or is still running.

The lock of Snakemake is off (workflow/profiles): it outlives its owner.
"""

import sys

from omniproof.lock import hold
from omniproof.recovery import forget, is_whole, keep, put_back, sweep
from omniproof.report.step import PART
from snakemake.persistence.file import FilePersistence

# The index stands for all pages: if another one was lost, it is made again with them.
if not is_whole(Path("book/_build/html"), Path("book/_build/files.txt")):
    FilePersistence().started(workflow.get_rule("book"))


onstart:
    if hold():
        os.execvp(
            sys.orig_argv[0], sys.orig_argv
        )  # plan anew: the other build may have made all
    sweep(PART, "results", "book/_build/html")
    keep(file for job in workflow.dag.needrun_jobs() for file in job.output)


onsuccess:
    forget()


onerror:
    for job in workflow.dag.needrun_jobs():
        if not all(map(os.path.exists, job.output)):
            workflow.persistence.started(job)
            put_back(job.output)
