"""
This part of the workflow runs the experiments anew in an open physics engine.

REQUIRED INPUTS:
    data = paper_data/{paper}/*

OUTPUTS:
    recordings = results/simulation/{model}/{case}.csv
    numbers    = results/simulation/{model}/summary.csv
    times      = results/benchmarks/simulation/{model}.csv
    summary    = results/simulation/summary.csv
"""

# One rule a model, since models differ in their cases and in the papers whose set-ups they take.
# Cases of an engine that has no package for this platform are left out; their chapter says so.
for model, cases in settings.simulation.items():
    runnable = [case for case in cases if can_run(case)]

    rule:
        """Simulate {params.model}"""
        name:
            f"simulation_{module_name(model)}"
        input:
            data=data_behind(f"simulation.{module_name(model)}"),
            package=package(f"simulation.{module_name(model)}", "simulation.files"),
        output:
            recordings=[f"results/simulation/{model}/{case}.csv" for case in runnable],
            numbers=f"results/simulation/{model}/summary.csv",
            times=f"results/benchmarks/simulation/{model}.csv",
        params:
            model=model,
            cases=runnable,
        log:
            f"logs/simulation/{model}.log",
        benchmark:
            f"results/benchmarks/simulation/{model}.tsv"
        script:
            "../scripts/simulation.py"


rule simulations:
    """Write the numbers of all simulations"""
    input:
        numbers=[f"results/simulation/{model}/summary.csv" for model in settings.simulation],
        package=package("simulation.files"),
    output:
        summary="results/simulation/summary.csv",
    log:
        "logs/simulations.log",
    benchmark:
        "results/benchmarks/simulations.tsv"
    script:
        "../scripts/simulations.py"
