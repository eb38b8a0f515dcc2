# Recordings for the rerun viewer: of all runs, of the small ones one a kind.
RUN = [*TRANSIENTS, *AUDITED, *PITCHING, *PISTONS]
REPLAYED = RUN
if CASES != "paper":
    REPLAYED = [TRANSIENTS[0], PITCHING[0], PISTONS[0]]
REPLAYS = [
    f"{RESULTS}/replay/{run.parent.name}_{run.stem}.rrd"
    for run in map(Path, dict.fromkeys(REPLAYED))
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
