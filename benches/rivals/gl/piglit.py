#!/usr/bin/env python3
"""Runs Piglit's tests on Mesa's OpenGL and on luxel's, and says which of them Mesa alone passes.

    benches/rivals/gl/piglit.py LIBRARIES [PATTERN]

LIBRARIES is the folder that `packaging/gl` made. Needs Debian's package `piglit`, Mesa's EGL, libglvnd and a C compiler.
PATTERN chooses tests by their names, as `re.search` does. Tests draw into framebuffer objects, without a screen. What they
need and luxel hasn't, they skip; those for shaders are left out from the beginning.
"""

import glob
import json
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

# Piglit draws into framebuffer objects where there is OpenGL 2.0 alone, and asks for nothing else of it there.
SHIM = r"""
#define _GNU_SOURCE
#include <dlfcn.h>
#include <string.h>
int piglit_get_gl_version(void)
{
    static int (*version)(void);
    Dl_info caller;
    if (!version)
        version = (int (*)(void))dlsym(RTLD_NEXT, "piglit_get_gl_version");
    int is = version();
    if (is < 20 && dladdr(__builtin_return_address(0), &caller) && caller.dli_sname
        && !strcmp(caller.dli_sname, "piglit_fbo_framework_create"))
        return 20;
    return is;
}
"""
OF_SHADERS = re.compile(r"shader_runner|glslparser|asmparser|gles|glsl-es|/vk|cl-")
# It asks for rectangle textures without looking whether there are any, and never ends.
ENDLESS = re.compile(r"/max-texture-size ")
SECONDS = 120


def programs(piglit: Path, pattern: str) -> dict[str, list[str]]:
    """The command of each test, one name for each command."""
    listed = subprocess.run(
        ["piglit", "print-cmd", "--format", "{name}@@{command}", "all"], capture_output=True, text=True, check=True
    )
    found: dict[tuple[str, ...], str] = {}
    for line in listed.stdout.splitlines():
        name, _, command = line.partition("@@")
        if not command or OF_SHADERS.search(line) or ENDLESS.search(f"{command} ") or not re.search(pattern, name):
            continue
        program, *arguments = command.split()
        path = piglit / "bin" / Path(program).name
        if path.exists():
            options = [option for option in ("-auto", "-fbo") if option not in arguments]
            found.setdefault((str(path), *arguments, *options), name)
    return {name: list(command) for command, name in found.items()}


def result(command: list[str], environment: dict[str, str]) -> str:
    """`pass`, `fail`, `skip`, `warn`, or what else became of a test."""
    try:
        done = subprocess.run(command, env=environment, capture_output=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return "timeout"
    answers = re.findall(r'PIGLIT: (\{.*"result".*\})', done.stdout.decode("utf-8", "replace"))
    if done.returncode < 0 or not answers:
        return f"exit {done.returncode}"
    return json.loads(answers[-1])["result"]


def main() -> None:
    libraries = Path(sys.argv[1]).resolve()
    piglit = Path(glob.glob("/usr/lib/*/piglit")[0])
    tests = programs(piglit, sys.argv[2] if len(sys.argv) > 2 else "")
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "shim.c").write_text(SHIM)
        subprocess.run(["cc", "-shared", "-fPIC", "-O1", "-o", "shim.so", "shim.c", "-ldl"], cwd=folder, check=True)
        mesa = dict(
            os.environ,
            PIGLIT_PLATFORM="surfaceless_egl",
            LIBGL_ALWAYS_SOFTWARE="1",
            PIGLIT_SOURCE_DIR=str(piglit),
        )
        luxel = dict(
            mesa,
            __EGL_VENDOR_LIBRARY_FILENAMES=str(libraries / "50_luxel.json"),
            LD_LIBRARY_PATH=str(libraries),
            LD_PRELOAD=str(Path(folder) / "shim.so"),
        )
        with ThreadPoolExecutor(os.cpu_count()) as threads:
            ours = dict(zip(tests, threads.map(lambda name: result(tests[name], luxel), tests)))
            ran = [name for name in tests if ours[name] != "skip"]
            theirs = dict(zip(ran, threads.map(lambda name: result(tests[name], mesa), ran)))
    passed = [name for name in ran if theirs[name] == "pass"]
    both = sum(ours[name] == "pass" for name in passed)
    more = sum(ours[name] == "pass" for name in ran) - both
    for name in passed:
        if ours[name] != "pass":
            print(f"{ours[name]:8} {name}")
    print(f"{len(tests)} tests, {len(ran)} of them run with luxel; Mesa passes {len(passed)}, luxel {both} of these and {more} others")


if __name__ == "__main__":
    main()
