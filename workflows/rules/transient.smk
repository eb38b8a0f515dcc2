# Section 3.6: mesh -> added mass -> roots -> runs, one job a run.
RUNS = cases("transient", CASES)
PRINTED = [
    (name, current) for name in RUNS["couplings"] for current in RUNS["currents"]
]
PRINTED += [(name, RUNS["currents"][0]) for name in RUNS["readings"]]
TRANSIENTS = [f"{RESULTS}/transient/{name}_{current}.nc" for name, current in PRINTED]
AUDITED = [
    f"{RESULTS}/transient/{name}_{RUNS['currents'][1]}.nc" for name in RUNS["audited"]
]
FREED = "_heave_pitch"  # in the name of a run whose ship is free to pitch
PITCHING = [
    f"{RESULTS}/transient/{name}{FREED}_{RUNS['currents'][-2]}.nc"
    for name in RUNS["pitching"]
]
MORE = RUNS["audited"] | {name + FREED: keys for name, keys in RUNS["pitching"].items()}


rule transient:
    input:
        mesh=rules.mesh.output[0],
        added_mass=f"{RESULTS}/added_mass/table6.nc",
        equilibria=rules.equilibria.output[0],
    output:
        f"{RESULTS}/transient/{{coupling}}_{{current}}.nc",
    log:
        f"{RESULTS}/logs/transient_{{coupling}}_{{current}}.log",
    benchmark:
        f"{RESULTS}/benchmarks/transient_{{coupling}}_{{current}}.tsv"
    wildcard_constraints:
        coupling="[a-z_]+",
        current="[0-9.]+",
    params:
        mesh=MESH,
        snapshots=RUNS["snapshots"],
        config=lambda wildcards: configured(
            "transient",
            f"mesh={MESH}",
            f"current={wildcards.current}",
            f"coupling={wildcards.coupling.removesuffix(FREED)}",
            *MORE.get(wildcards.coupling, []),
        ),
        coupling=lambda wildcards: wildcards.coupling.removesuffix(FREED),
        more=lambda wildcards: MORE.get(wildcards.coupling, []),
    shell:
        "squat task=transient mesh={params.mesh} current={wildcards.current}"
        " coupling={params.coupling} snapshots={params.snapshots} {params.more:q}"
        " 'inputs.mesh=\"{input.mesh}\"' 'inputs.added_mass=\"{input.added_mass}\"'"
        " 'inputs.equilibria=\"{input.equilibria}\"' 'out=\"{output}\"' > {log:q} 2>&1"
