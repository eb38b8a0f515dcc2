# The reduced model of the ship of section 3.6, and the fate of ships released in any current.


rule reduced:
    input:
        mesh=rules.mesh.output[0],
    output:
        f"{RESULTS}/reduced/reduced.nc",
    log:
        f"{RESULTS}/logs/reduced.log",
    benchmark:
        f"{RESULTS}/benchmarks/reduced.tsv"
    params:
        mesh=MESH,
        config=configured("reduced", f"mesh={MESH}"),
    shell:
        "squat task=reduced mesh={params.mesh} 'inputs.mesh=\"{input.mesh}\"' 'out=\"{output}\"' > {log:q} 2>&1"


rule stability_map:
    input:
        reduced=rules.reduced.output[0],
    output:
        f"{RESULTS}/reduced/stability_map.nc",
    log:
        f"{RESULTS}/logs/stability_map_data.log",
    benchmark:
        f"{RESULTS}/benchmarks/stability_map_data.tsv"
    params:
        cases=f"cases/map@_global_={CASES}",
        mesh=MESH,
        config=configured(
            "stability_map", f"cases/map@_global_={CASES}", f"mesh={MESH}"
        ),
    shell:
        "squat task=stability_map {params.cases} mesh={params.mesh} 'inputs.reduced=\"{input.reduced}\"'"
        " 'out=\"{output}\"' > {log:q} 2>&1"
