# Section 3.3: equilibria of the one-dimensional model.


rule equilibria:
    output:
        f"{RESULTS}/equilibria/equilibria.nc",
    log:
        f"{RESULTS}/logs/equilibria.log",
    benchmark:
        f"{RESULTS}/benchmarks/equilibria.tsv"
    params:
        cases=f"cases/squat@speeds={CASES}",
        config=configured("equilibria", f"cases/squat@speeds={CASES}"),
    shell:
        "squat task=equilibria {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"
