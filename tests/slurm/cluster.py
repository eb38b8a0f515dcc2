"""A SLURM of two nodes on this machine's loopback: Debian's slurm-wlm and munge, as root."""

import os
import pwd
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "srun")
CONFIGURATION = Path("/etc/slurm/slurm.conf")
TEMPLATE = """
ClusterName=squat
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={munge}
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
SlurmdParameters=config_overrides
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory,CR_LLN
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MinJobAge=3600
ReturnToService=2
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={first} CPUs=8 RealMemory=16000
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={second} CPUs=8 RealMemory=16000
PartitionName=main Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
"""


class Cluster:
    """Use as a context: daemons are started in `folder` and ended by their ids."""

    def __init__(self, folder: Path):
        self.folder = folder
        self._daemons: list[subprocess.Popen] = []

    def __enter__(self):
        missing = [name for name in PROGRAMS if shutil.which(name, path=_path()) is None]
        assert not missing, f"{', '.join(missing)} missing: apt-get install slurm-wlm munge"
        assert os.getuid() == 0, "SLURM's daemons need root"
        assert not CONFIGURATION.exists(), f"{CONFIGURATION} exists: this machine has a SLURM"
        try:
            self._start()
        except BaseException:
            self.__exit__()
            raise
        return self

    def _start(self) -> None:
        for name in ("state", "spool-n1", "spool-n2", "munge"):
            (self.folder / name).mkdir(parents=True)
        munge = self._munge()
        ports = dict(zip(("controller", "first", "second"), _ports(3), strict=True))
        text = TEMPLATE.format(host=socket.gethostname(), folder=self.folder, munge=munge, **ports)
        path = self.folder / "slurm.conf"
        path.write_text(text)
        CONFIGURATION.parent.mkdir(exist_ok=True)
        # The commands read this place; the variable SLURM_CONF does not reach all of them.
        CONFIGURATION.symlink_to(path)
        self._daemon("slurmctld", "-D")
        for node in ("n1", "n2"):
            self._daemon("slurmd", "-D", "-N", node)
        self._wait(lambda: self.ask("sinfo", "-h", "-o", "%T %D") == "idle 2", "idle nodes")

    def _munge(self) -> Path:
        folder = self.folder / "munge"
        key, place = folder / "key", folder / "socket"
        key.write_bytes(os.urandom(1024))
        key.chmod(0o600)
        owner = pwd.getpwuid(os.getuid())
        shutil.chown(key, owner.pw_uid, owner.pw_gid)
        files = {"key-file": key, "socket": place, "pid-file": folder / "pid"}
        files |= {"log-file": folder / "log", "seed-file": folder / "seed"}
        self._daemon("munged", "--foreground", "--force", *(f"--{k}={v}" for k, v in files.items()))
        self._wait(place.exists, "munge's socket")
        return place

    def _daemon(self, *command: str) -> None:
        with (self.folder / f"{command[0]}{command[-1]}.out".replace("/", "_")[-80:]).open(
            "w"
        ) as log:
            program = shutil.which(command[0], path=_path())
            started = subprocess.Popen([program, *command[1:]], stdout=log, stderr=log)
        self._daemons.append(started)

    def _wait(self, done, what: str, seconds: float = 60) -> None:
        until = time.monotonic() + seconds
        while not done():
            logs = sorted(self.folder.glob("*.log")) + sorted(self.folder.glob("*.out"))
            tails = "\n".join(f"{log.name}: {log.read_text()[-600:]}" for log in logs)
            assert time.monotonic() < until, f"no {what} in {seconds} s\n{tails}"
            time.sleep(0.2)

    def ask(self, *command: str) -> str:
        """Standard output of one of SLURM's commands; empty where it fails."""
        return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()

    @property
    def jobs(self) -> list[dict[str, str]]:
        """All jobs so far (elements of arrays one by one): their fields by name."""
        lines = self.ask("scontrol", "show", "jobs", "-o").splitlines()
        found = (line for line in lines if line.startswith("JobId="))
        pairs = ([word.partition("=") for word in line.split()] for line in found)
        return [{key: value for key, _, value in words} for words in pairs]

    def __exit__(self, *error):
        if self._daemons and CONFIGURATION.is_symlink():
            self.ask("scancel", "--me")
            CONFIGURATION.unlink()
        for daemon in reversed(self._daemons):
            daemon.send_signal(signal.SIGTERM)
        for daemon in self._daemons:
            daemon.wait(timeout=30)


def _path() -> str:
    return f"{os.environ['PATH']}:/usr/sbin:/sbin"


def _ports(count: int) -> list[int]:
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [opened.getsockname()[1] for opened in sockets]
    for opened in sockets:
        opened.close()
    return ports
