"""A fresh Debian system in a folder, for packages to be installed into: debootstrap from the mirror that this system's own apt uses."""
import os
import pathlib
import shutil
import subprocess


class Impossible(Exception):
    """No such system can be made here."""


def mirror():
    """URL and release of the first index that apt reads its packages from, and the components of it."""
    if not shutil.which("apt-get"):
        raise Impossible("there is no apt here")
    lines = subprocess.run(["apt-get", "indextargets", "--format", "$(SITE) $(CODENAME) $(COMPONENT)", "Created-By: Packages"],
                           capture_output=True, text=True).stdout.split("\n")
    if not lines[0]:
        raise Impossible("apt knows no package index; apt-get update may help")
    return lines[0].split()


class CleanSystem:
    def __init__(self, folder):
        self.root = pathlib.Path(folder) / "root"
        if os.geteuid() != 0:
            raise Impossible("only root can make a system to change the root to")
        if not shutil.which("debootstrap"):
            raise Impossible("debootstrap is not installed")
        site, release, component = mirror()
        made = subprocess.run(["debootstrap", "--variant=minbase", f"--components={component}", release, self.root, site],
                              capture_output=True, text=True)
        if made.returncode != 0:
            raise Impossible("debootstrap failed: " + made.stdout[-500:] + made.stderr[-500:])
        # As apt is set up here, so that packages come from where this machine may fetch them.
        (self.root / "etc/apt/sources.list").unlink()
        for name in ("etc/apt/sources.list", "etc/apt/sources.list.d", "etc/apt/apt.conf.d", "etc/resolv.conf", "etc/hosts"):
            here = pathlib.Path("/") / name
            if here.is_dir():
                shutil.copytree(here, self.root / name, dirs_exist_ok=True)
            elif here.exists():
                shutil.copy(here, self.root / name)
        (self.root / "usr/sbin/policy-rc.d").write_text("#!/bin/sh\nexit 101\n")  # no services
        (self.root / "usr/sbin/policy-rc.d").chmod(0o755)

    def run(self, command, status=0, **more):
        """Runs a shell command line inside; its output."""
        mounts = f"mount -t proc proc {self.root}/proc && mount -t tmpfs tmpfs {self.root}/dev/shm && "
        environment = {"PATH": "/usr/sbin:/usr/bin:/sbin:/bin", "HOME": "/root", "LANG": "C.UTF-8",
                       "DEBIAN_FRONTEND": "noninteractive", **more}
        done = subprocess.run(["unshare", "-m", "sh", "-c", mounts + 'exec chroot "$@"', "sh", str(self.root), "sh", "-c", command],
                              env=environment, capture_output=True, text=True, timeout=1500)
        assert done.returncode == status, f"{command} ended with {done.returncode}:\n{done.stdout[-4000:]}{done.stderr[-4000:]}"
        return done.stdout + done.stderr

    def files(self):
        """Every path that a package could have left: not what is mounted, and not apt's and dpkg's own books."""
        found = set()
        for folder, folders, names in os.walk(self.root):
            here = "/" + os.path.relpath(folder, self.root)
            if here in ("/proc", "/sys", "/dev", "/tmp", "/var/lib/apt", "/var/lib/dpkg", "/var/cache", "/var/log"):
                folders.clear()
                continue
            found.update(os.path.join(here, name) for name in folders + names)
        return found
