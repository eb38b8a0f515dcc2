# Section 2: the piston in a U-tube.


rule iterations:
    output:
        f"{RESULTS}/piston/iterations.nc",
    log:
        f"{RESULTS}/logs/iterations.log",
    benchmark:
        f"{RESULTS}/benchmarks/iterations.tsv"
    threads: CORES
    params:
        cases=f"cases/piston@cells={CASES}",
        config=configured("iterations", f"cases/piston@cells={CASES}"),
    shell:
        "LOKY_MAX_CPU_COUNT={threads} squat task=iterations {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"


SINGLE = cases("piston_runs", CASES)
PISTONS = [
    f"{RESULTS}/piston/{scheme}_{ratio}.nc"
    for scheme in SINGLE["schemes"]
    for ratio in SINGLE["mass_ratios"]
]


rule piston:
    output:
        f"{RESULTS}/piston/{{scheme}}_{{ratio}}.nc",
    log:
        f"{RESULTS}/logs/piston_{{scheme}}_{{ratio}}.log",
    benchmark:
        f"{RESULTS}/benchmarks/piston_{{scheme}}_{{ratio}}.tsv"
    wildcard_constraints:
        scheme="[a-z]+",
        ratio="[0-9.]+",
    params:
        config=lambda wildcards: configured(
            "piston",
            f"scheme={wildcards.scheme}",
            f"piston.mass_ratio={wildcards.ratio}",
        ),
    shell:
        "squat task=piston scheme={wildcards.scheme} piston.mass_ratio={wildcards.ratio}"
        " 'out=\"{output}\"' > {log:q} 2>&1"
