# Everything that is not the report, and the report made of it.


rule contents:
    input:
        rules.iterations.output,
        rules.equilibria.output,
        rules.limits.output,
        rules.convergence.output,
        rules.verdicts.output,
        REPLAYS,
        expand(rules.table.output, table=TABLES),
        expand(
            f"{RESULTS}/figures/{{figure}}.{{suffix}}",
            figure=FIGURES,
            suffix=["png", "svg"],
        ),


rule report:
    input:
        rules.contents.input,
    output:
        f"{RESULTS}/report.html",
    log:
        f"{RESULTS}/logs/report.log",
    benchmark:
        f"{RESULTS}/benchmarks/report.tsv"
    params:
        results=RESULTS,
        members=lambda wildcards: ",".join(
            f'"{path}"'
            for path in dict.fromkeys([*rules.iterations.output, *RUN, *REPLAYS])
        ),
        config=configured("report"),
    shell:
        "squat task=report 'results=\"{params.results}\"' 'members=[{params.members}]' 'out=\"{output}\"' > {log:q} 2>&1"
