# Every coupling scheme with every accelerator, on piston and ship.


rule race:
    output:
        f"{RESULTS}/race/race.nc",
    log:
        f"{RESULTS}/logs/race.log",
    benchmark:
        f"{RESULTS}/benchmarks/race.tsv"
    threads: CORES
    params:
        cases=f"cases/race@cells={CASES}",
        config=configured("race", f"cases/race@cells={CASES}"),
    shell:
        "LOKY_MAX_CPU_COUNT={threads} squat task=race {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"
