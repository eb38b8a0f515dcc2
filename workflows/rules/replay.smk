# Recordings of all runs, for the rerun viewer.
REPLAYS = [
    f"{RESULTS}/replay/{run.parent.name}_{run.stem}.rrd"
    for run in map(Path, dict.fromkeys([*TRANSIENTS, *AUDITED, *PITCHING, *PISTONS]))
]


rule replay:
    input:
        f"{RESULTS}/{{room}}/{{name}}.nc",
    output:
        f"{RESULTS}/replay/{{room}}_{{name}}.rrd",
    log:
        f"{RESULTS}/logs/replay_{{room}}_{{name}}.log",
    benchmark:
        f"{RESULTS}/benchmarks/replay_{{room}}_{{name}}.tsv"
    wildcard_constraints:
        room="transient|piston",
    shell:
        "squat task=replay 'run=\"{input}\"' 'out=\"{output}\"' > {log:q} 2>&1"
