# Heave with pitch: equilibria and limits of the ship of section 3.6.


rule trim:
    output:
        f"{RESULTS}/trim/trim.nc",
    log:
        f"{RESULTS}/logs/trim.log",
    benchmark:
        f"{RESULTS}/benchmarks/trim.tsv"
    params:
        cases=f"cases/trim@_global_={CASES}",
        config=configured("trim", f"cases/trim@_global_={CASES}"),
    shell:
        "squat task=trim {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"
