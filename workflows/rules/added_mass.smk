# Sections 3.2 and 3.5: added mass. Tables 4 and 5 are one rule that runs its cells over the cores.
SUFFIX = "" if CASES == "paper" else f"_{CASES}"
HULLS = {
    "table6": "",
    "fig7": "hull=fig7 channel=fig7",
}


rule inertia:
    output:
        f"{RESULTS}/added_mass/{{table}}.nc",
    log:
        f"{RESULTS}/logs/{{table}}_cells.log",
    benchmark:
        f"{RESULTS}/benchmarks/{{table}}_cells.tsv"
    wildcard_constraints:
        table="table4|table5",
    threads: CORES
    params:
        cases=lambda wildcards: f"cases/inertia@cells={wildcards.table}{SUFFIX}",
        accuracy=ACCURACY,
        config=lambda wildcards: configured(
            "inertia",
            f"cases/inertia@cells={wildcards.table}{SUFFIX}",
            f"accuracy={ACCURACY}",
        ),
    shell:
        "LOKY_MAX_CPU_COUNT={threads} squat task=inertia {params.cases} accuracy={params.accuracy}"
        " 'out=\"{output}\"' > {log:q} 2>&1"


rule added_mass:
    output:
        f"{RESULTS}/added_mass/{{hull}}.nc",
    log:
        f"{RESULTS}/logs/{{hull}}_added_mass.log",
    benchmark:
        f"{RESULTS}/benchmarks/{{hull}}_added_mass.tsv"
    wildcard_constraints:
        hull="|".join(HULLS),
    params:
        hull=lambda wildcards: HULLS[wildcards.hull],
        mesh=MESH,
        accuracy=ACCURACY,
        config=lambda wildcards: configured(
            "added_mass",
            *HULLS[wildcards.hull].split(),
            f"mesh={MESH}",
            f"accuracy={ACCURACY}",
        ),
    shell:
        "squat task=added_mass {params.hull} mesh={params.mesh} accuracy={params.accuracy}"
        " 'out=\"{output}\"' > {log:q} 2>&1"


rule sensitivity:
    output:
        f"{RESULTS}/added_mass/sensitivity.nc",
    log:
        f"{RESULTS}/logs/sensitivity.log",
    benchmark:
        f"{RESULTS}/benchmarks/sensitivity.tsv"
    params:
        cases=f"cases/sensitivity@_global_={CASES}",
        accuracy=ACCURACY,
        config=configured(
            "sensitivity",
            f"cases/sensitivity@_global_={CASES}",
            f"accuracy={ACCURACY}",
        ),
    shell:
        "squat task=sensitivity {params.cases} accuracy={params.accuracy} 'out=\"{output}\"' > {log:q} 2>&1"
