# Section 3.1.3: the mesh and the submesh that moves it.


rule mesh:
    output:
        f"{RESULTS}/mesh/mesh.nc",
    log:
        f"{RESULTS}/logs/mesh.log",
    benchmark:
        f"{RESULTS}/benchmarks/mesh.tsv"
    params:
        mesh=MESH,
        config=configured("mesh", f"mesh={MESH}"),
    shell:
        "squat task=mesh mesh={params.mesh} 'out=\"{output}\"' > {log:q} 2>&1"
