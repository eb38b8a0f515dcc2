# Printed numbers beside ours.
ADDED_MASS = f"{RESULTS}/added_mass"
TABLES = {
    "table1": rules.iterations.output[0],
    "table2": rules.iterations.output[0],
    "table3": rules.iterations.output[0],
    "table4": f"{ADDED_MASS}/table4.nc",
    "table5": f"{ADDED_MASS}/table5.nc",
    "table5_critical": f"{ADDED_MASS}/table5.nc",
    "table6": f"{ADDED_MASS}/table6.nc",
    "table7": rules.equilibria.output[0],
}


rule table:
    input:
        lambda wildcards: TABLES[wildcards.table],
    output:
        f"{RESULTS}/tables/{{table}}.csv",
    log:
        f"{RESULTS}/logs/{{table}}.log",
    benchmark:
        f"{RESULTS}/benchmarks/{{table}}.tsv"
    wildcard_constraints:
        table="|".join(TABLES),
    shell:
        "squat task=table name={wildcards.table} 'data=\"{input}\"' 'out=\"{output}\"'"
        " > {log:q} 2>&1"


rule verdicts:
    input:
        tables=expand(rules.table.output, table=TABLES),
        iterations=rules.iterations.output[0],
        equilibria=rules.equilibria.output[0],
        table4=f"{ADDED_MASS}/table4.nc",
        table5=f"{ADDED_MASS}/table5.nc",
        table6=f"{ADDED_MASS}/table6.nc",
        limits=rules.limits.output[0],
        transients=TRANSIENTS,
    output:
        f"{RESULTS}/tables/verdicts.csv",
    log:
        f"{RESULTS}/logs/verdicts.log",
    benchmark:
        f"{RESULTS}/benchmarks/verdicts.tsv"
    params:
        tables=lambda wildcards, input: ",".join(f'"{name}"' for name in input.tables),
        transients=lambda wildcards, input: ",".join(
            f'"{name}"' for name in input.transients
        ),
        data=lambda wildcards, input: " ".join(
            f"'{name}=\"{path}\"'"
            for name, path in input.items()
            if name not in ("tables", "transients")
        ),
    shell:
        "squat task=verdicts 'tables=[{params.tables}]' {params.data} 'transients=[{params.transients}]' 'out=\"{output}\"'"
        " > {log:q} 2>&1"
