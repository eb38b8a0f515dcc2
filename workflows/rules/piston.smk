# Section 2: the piston in a U-tube.


rule iterations:
    output:
        f"{RESULTS}/piston/iterations.nc",
    log:
        f"{RESULTS}/logs/iterations.log",
    benchmark:
        f"{RESULTS}/benchmarks/iterations.tsv"
    threads: workflow.cores
    params:
        cases=f"cases/piston@cells={CASES}",
        config=configured("iterations", f"cases/piston@cells={CASES}"),
    shell:
        "squat task=iterations {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"
