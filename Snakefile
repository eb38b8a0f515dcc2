# The paper as a graph: `snakemake all` leaves its tables, figures and report in results/.
#
#   snakemake all --config results=elsewhere cases=small     the same, smaller, elsewhere
#   snakemake --rulegraph mermaid-js                         the graph
#
# A rule calls the command that a person would type. Numbers live in conf/.
import sys
from pathlib import Path

sys.path.insert(0, workflow.basedir)

from workflows.graph import cases, configured

RESULTS = config.get("results", "results")
CASES = config.get("cases", "paper")
# Of jobs that spread over the cores: small ones are done before the others would have made room.
CORES = workflow.cores if CASES == "paper" else 1
# Meshes of the jobs whose cases do not choose their own.
ACCURACY = "default" if CASES == "paper" else "coarse"
MESH = "paper" if CASES == "paper" else "coarse"


wildcard_constraints:
    number=r"\d+",


include: "workflows/rules/piston.smk"
include: "workflows/rules/equilibria.smk"
include: "workflows/rules/mesh.smk"
include: "workflows/rules/added_mass.smk"
include: "workflows/rules/transient.smk"
include: "workflows/rules/stability.smk"
include: "workflows/rules/trim.smk"
include: "workflows/rules/reduced.smk"
include: "workflows/rules/race.smk"
include: "workflows/rules/replay.smk"
include: "workflows/rules/analysis.smk"
include: "workflows/rules/figures.smk"
include: "workflows/rules/report.smk"


localrules:
    all,


rule all:
    default_target: True
    input:
        rules.contents.input,
        rules.report.output,
