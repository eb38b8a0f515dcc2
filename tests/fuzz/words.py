"""What is typed wrongly: values by kind, choices, options, files."""

# fmt: off
WORDS = {
    "type": [
        "abc", "true", "[]", "{}", "[1,2]", "{a:1}", "'1'", "null", "1.5.2", "0x1p4", "1j",
    ],
    "range": [
        "-1", "-1e-9", "-1e300", "1e300", "1e13", "5e-324", "-0.5", "10000000000000000000",
    ],
    "finite": [
        "nan", "-nan", "inf", "-inf", ".inf", ".nan", "NaN", "Infinity", "1e999", "-1e999",
    ],
    "empty": [
        "", "''", "\"\"", "'  '", "[[]]", "[null]", "[[],[]]",
    ],
    "units": [
        "10m", "'10 m'", "3km/h", "5%", "2,5", "1_000 m", "10ft", "1e3Pa", "'1,000'",
    ],
    "unicode": [
        "\u03c9", "'\uff11\uff12'", "\u200b1", "\uff11", "\u22121", "\xbd", "\ufb00",
        "\U0001f6a2", "'a\x00b'", "\xe9=\xe9",
    ],
    "syntax": [
        "[", "]", "{", "'", "\"", "[1,", "{a:", "(", "\\", "$", "${", "${}", "a=b", "=", ",",
        "1,2,3", "range(1,3)", "choice(a,b)", "glob(*)", "shuffle(1)", "interval(0,1)", "\n",
        "int(", "float(x)", "str(1", "json_str()", "a b", "#", "!!python/object/apply:os.system",
    ],
    "interpolation": [
        "${no}", "${no:1}", "${hull}", "${oc.env:SURELY_NOT_SET}", "${hydra:no}",
        "${oc.decode:'['}", "${oc.select:no}", "${.}", "${..}", "${task}", "${out",
        "${oc.create:{a:1}}", "${oc.dict.keys:task}", "${${task}}", "${this}",
    ],
    "path": [
        "no.nc", "no/where.nc", "sweep", ".", "/", "/dev/null", "/proc/self/mem", "secret.nc",
        "text.nc", "good.nc/x.nc", "~/no.nc", "''",
        "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa.nc",
        "link.nc", "../no.nc",
    ],
    "length": [
        "[]", "[1]", "[1,2,3,4,5]", "[[1,2],[3]]", "[[1],[2]]", "[[1,2,3],[4,5,6],[7,8,9]]",
    ],
}
CHOICES = [
    "none", "nothing", "Paper", "pape", "../paper", "/etc/passwd", "a/b", "[a,b]",
    "rectangle.yaml", "1", "null", "true",
]
EVIL = [
    "os.system", "subprocess.Popen", "builtins.exec", "os.mkdir",
    "squat.records.provenance.subprocess.run", "pathlib.Path.touch",
]
HYDRA = [
    "hydra.run.dir=/proc/x", "hydra.run=1", "hydra.job=null", "hydra=1", "hydra.job.chdir=maybe",
    "hydra.launcher.n_jobs=many", "hydra.mode=NONE", "hydra.verbose=[", "hydra/launcher=no",
    "hydra/sweeper=no", "hydra.searchpath=[file://no]", "hydra.callbacks=1",
    "hydra.searchpath=1", "hydra.job_logging=1", "hydra/job_logging=no", "+hydra.x=1",
    "hydra.job.env_set.X=[1]", "hydra.job.config=1",
    "hydra.job.name=[]", "hydra.help=0", "hydra.sweep.dir=/proc/y",
]
OPTIONS = [
    "--nonsense", "-x", "--cfg", "--cfg=all", "--config-name", "-cn=no", "--config-dir=no",
    "--config-path=no", "--", "-", "--resolve", "--package", "--run=1", "--info=no", "-cn", "-p",
    "--experimental-rerun=no", "--experimental-rerun=text.nc", "--shell-completion", "-h=1",
    "--version=1", "=1", "+", "~", "++x", "@", "a:b@c=d",
]
TASKS = [
    "", "null", "Piston", "piston,mesh", "[piston]", "1", "../config", "piston.yaml", "all",
    "\u03c9", "${out}", "{a:1}",
]
BROKEN = [
    "truncated.nc", "flipped.nc", "foreign.nc", "future.nc", "empty.nc", "text.nc", "altered.nc",
    "no.nc", "sweep/sub.d", "secret.nc", "group.nc",
]
