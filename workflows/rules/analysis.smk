# Printed numbers beside ours.
TABLES = {
    1: rules.iterations.output[0],
    2: rules.iterations.output[0],
    3: rules.iterations.output[0],
    7: rules.equilibria.output[0],
}


rule table:
    input:
        lambda wildcards: TABLES[int(wildcards.number)],
    output:
        csv=f"{RESULTS}/tables/table{{number}}.csv",
        page=report(
            f"{RESULTS}/tables/table{{number}}.html",
            caption=caption("table"),
            category="The paper's tables",
            labels={"table": "Table {number}"},
        ),
    log:
        f"{RESULTS}/logs/table{{number}}.log",
    benchmark:
        f"{RESULTS}/benchmarks/table{{number}}.tsv"
    shell:
        "squat task=table number={wildcards.number} 'data=\"{input}\"' 'out=\"{output.csv}\"'"
        " > {log:q} 2>&1"


rule verdicts:
    input:
        tables=expand(rules.table.output.csv, number=TABLES),
        iterations=rules.iterations.output[0],
        equilibria=rules.equilibria.output[0],
    output:
        csv=f"{RESULTS}/tables/verdicts.csv",
        page=report(
            f"{RESULTS}/tables/verdicts.html",
            caption=caption("verdicts"),
            category="Summary",
            labels={"table": "All verdicts"},
        ),
    log:
        f"{RESULTS}/logs/verdicts.log",
    benchmark:
        f"{RESULTS}/benchmarks/verdicts.tsv"
    params:
        tables=lambda wildcards, input: ",".join(f'"{name}"' for name in input.tables),
    shell:
        "squat task=verdicts 'tables=[{params.tables}]' 'iterations=\"{input.iterations}\"'"
        " 'equilibria=\"{input.equilibria}\"' 'out=\"{output.csv}\"' > {log:q} 2>&1"
