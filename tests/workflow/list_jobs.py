"""Print the jobs of a build from scratch as one line of JSON (run in a project's folder)."""

import json
from pathlib import Path

from snakemake.api import SnakemakeApi
from snakemake.settings.enums import Quietness
from snakemake.settings.types import DAGSettings, OutputSettings, ResourceSettings


def record(job):
    """Return what the tests look at of a job."""
    return {
        "rule": job.rule.name,
        "title": job.message,
        "rules": Path(job.rule.snakefile).name,
        "script": job.rule.script,
        "input": named(job.input),
        "output": named(job.output),
        "log": list(map(str, job.log)),
        "benchmark": str(job.benchmark or ""),
    }


def named(files):
    """Return the files by name, each as a list."""
    return {
        name: [value] if isinstance(value, str) else list(value) for name, value in files.items()
    }


with SnakemakeApi(OutputSettings(quiet={Quietness.ALL}, enable_file_logging=False)) as api:
    workflow_api = api.workflow(
        resource_settings=ResourceSettings(cores=1), snakefile=Path("Snakefile")
    )
    workflow_api.dag(DAGSettings(forceall=True))
    workflow = workflow_api._workflow
    workflow._prepare_dag(forceall=True, ignore_incomplete=True, lock_warn_only=True)
    workflow._build_dag()
    print(json.dumps([record(job) for job in workflow.dag.jobs]))
