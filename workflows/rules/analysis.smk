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
        trim=rules.trim.output[0],
        transients=TRANSIENTS,
        pitching=PITCHING,
    output:
        f"{RESULTS}/tables/verdicts.csv",
    log:
        f"{RESULTS}/logs/verdicts.log",
    benchmark:
        f"{RESULTS}/benchmarks/verdicts.tsv"
    params:
        tables=lambda wildcards, input: ",".join(f'"{name}"' for name in input.tables),
        runs=lambda wildcards, input: " ".join(
            "'{}=[{}]'".format(name, ",".join(f'"{path}"' for path in input[name]))
            for name in ("transients", "pitching")
        ),
        data=lambda wildcards, input: " ".join(
            f"'{name}=\"{path}\"'"
            for name, path in input.items()
            if name not in ("tables", "transients", "pitching")
        ),
    shell:
        "squat task=verdicts 'tables=[{params.tables}]' {params.data} {params.runs} 'out=\"{output}\"'"
        " > {log:q} 2>&1"
