# What the energies alone imply: portrait and limits of the ship of section 3.6, limits of others.


rule stability:
    output:
        f"{RESULTS}/stability/stability.nc",
    log:
        f"{RESULTS}/logs/stability.log",
    benchmark:
        f"{RESULTS}/benchmarks/stability.tsv"
    params:
        cases=f"cases/stability@speeds={CASES} portrait={CASES}",
        mesh=MESH,
        config=configured(
            "stability",
            f"cases/stability@speeds={CASES}",
            f"portrait={CASES}",
            f"mesh={MESH}",
        ),
    shell:
        "squat task=stability {params.cases} mesh={params.mesh} 'out=\"{output}\"' > {log:q} 2>&1"


rule limits:
    output:
        f"{RESULTS}/stability/limits.nc",
    log:
        f"{RESULTS}/logs/limits_table.log",
    benchmark:
        f"{RESULTS}/benchmarks/limits_table.tsv"
    params:
        accuracy=ACCURACY,
        config=configured("limits", f"accuracy={ACCURACY}"),
    shell:
        "squat task=limits accuracy={params.accuracy} 'out=\"{output}\"' > {log:q} 2>&1"


rule limits_map:
    output:
        f"{RESULTS}/stability/limits_map.nc",
    log:
        f"{RESULTS}/logs/limits_study.log",
    benchmark:
        f"{RESULTS}/benchmarks/limits_study.tsv"
    threads: CORES
    params:
        cases=f"cases/limits@_global_={CASES}",
        config=configured("limits_map", f"cases/limits@_global_={CASES}"),
    shell:
        "LOKY_MAX_CPU_COUNT={threads} squat task=limits_map {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"


rule uneven_bottom:
    output:
        f"{RESULTS}/stability/uneven_bottom.nc",
    log:
        f"{RESULTS}/logs/uneven_bottom_study.log",
    benchmark:
        f"{RESULTS}/benchmarks/uneven_bottom_study.tsv"
    threads: CORES
    params:
        cases=f"cases/uneven_bottom@_global_={CASES}",
        config=configured("uneven_bottom", f"cases/uneven_bottom@_global_={CASES}"),
    shell:
        "LOKY_MAX_CPU_COUNT={threads} squat task=uneven_bottom {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"


rule hull_shapes:
    output:
        f"{RESULTS}/stability/hull_shapes.nc",
    log:
        f"{RESULTS}/logs/hull_shapes.log",
    benchmark:
        f"{RESULTS}/benchmarks/hull_shapes.tsv"
    threads: CORES
    params:
        cases=f"cases/hull_shapes@_global_={CASES}",
        config=configured("hull_shapes", f"cases/hull_shapes@_global_={CASES}"),
    shell:
        "LOKY_MAX_CPU_COUNT={threads} squat task=hull_shapes {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"


rule convergence:
    output:
        f"{RESULTS}/stability/convergence.nc",
    log:
        f"{RESULTS}/logs/convergence.log",
    benchmark:
        f"{RESULTS}/benchmarks/convergence.tsv"
    params:
        cases=f"cases/convergence@_global_={CASES}",
        config=configured("convergence", f"cases/convergence@_global_={CASES}"),
    shell:
        "squat task=convergence {params.cases} 'out=\"{output}\"' > {log:q} 2>&1"
