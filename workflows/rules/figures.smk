# Figures, as PNG and SVG; one rule a figure. Captions: conf/contents/paper.yaml.
FIGURES = {
    "fig3": rules.mesh.output[0],
    "fig5": rules.mesh.output[0],
    "fig6": rules.mesh.output[0],
    "fig7": f"{ADDED_MASS}/fig7.nc",
    "fig8": rules.mesh.output[0],
    "fig9": f"{ADDED_MASS}/table5.nc",
    "fig10": rules.equilibria.output[0],
    "fig11": [
        f"{RESULTS}/transient/printed_{current}.nc" for current in RUNS["currents"]
    ],
    "fig12": f"{RESULTS}/transient/printed_{RUNS['currents'][0]}.nc",
    "fig13": [
        f"{RESULTS}/transient/printed_{current}.nc"
        for current in RUNS["currents"][1::2]
    ],
    "energy_audit": AUDITED,
    "potential": rules.stability.output[0],
    "phase_portrait": rules.stability.output[0],
    "limits": rules.stability.output[0],
    "basins": rules.stability.output[0],
    "limits_map": rules.limits_map.output[0],
    "hull_shapes": rules.hull_shapes.output[0],
    "stability_map": rules.stability_map.output[0],
    "iterations": rules.iterations.output[0],
    "trim": rules.trim.output[0],
    "uneven_bottom": rules.uneven_bottom.output[0],
    "race": rules.race.output[0],
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
            png=f"{RESULTS}/figures/{FIGURE}.png",
            svg=f"{RESULTS}/figures/{FIGURE}.svg",
        log:
            f"{RESULTS}/logs/figure_{FIGURE}.log",
        benchmark:
            f"{RESULTS}/benchmarks/figure_{FIGURE}.tsv"
        params:
            figure=FIGURE,
            data=lambda wildcards, input: ",".join(f'"{name}"' for name in input),
        shell:
            "squat task=figure figure={params.figure} 'data=[{params.data}]' 'out=\"{output.png}\"'"
            " > {log:q} 2>&1"
