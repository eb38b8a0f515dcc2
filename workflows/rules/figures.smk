# Figures, as PNG and SVG; one rule a figure, so that each has its caption in the report.
FIGURES = {
    "fig3": rules.mesh.output[0],
    "fig5": rules.mesh.output[0],
    "fig6": rules.mesh.output[0],
    "fig7": f"{ADDED_MASS}/fig7.nc",
    "fig8": rules.mesh.output[0],
    "fig9": f"{ADDED_MASS}/table5.nc",
    "fig10": rules.equilibria.output[0],
    "iterations": rules.iterations.output[0],
    "mesh_quality": rules.mesh.output[0],
    "sensitivity": f"{ADDED_MASS}/sensitivity.nc",
}

for FIGURE, SOURCE in FIGURES.items():

    rule:
        name:
            f"figure_{FIGURE}"
        input:
            SOURCE,
        output:
            png=report(
                f"{RESULTS}/figures/{FIGURE}.png",
                caption=caption(FIGURE),
                category="Figures",
                labels={"figure": FIGURE},
            ),
            svg=f"{RESULTS}/figures/{FIGURE}.svg",
        log:
            f"{RESULTS}/logs/{FIGURE}.log",
        benchmark:
            f"{RESULTS}/benchmarks/{FIGURE}.tsv"
        params:
            figure=FIGURE,
        shell:
            "squat task=figure figure={params.figure} 'data=\"{input}\"' 'out=\"{output.png}\"'"
            " > {log:q} 2>&1"
