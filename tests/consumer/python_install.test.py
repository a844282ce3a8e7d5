"""The Python packages as a user gets them: installed by pip into an environment of their own, without any index, and the
notebooks run there. The build of the tests is taken for the extension module.

usage: python_install.test.py SOURCE BUILD
"""
import os
import pathlib
import subprocess
import sys
import tempfile

source, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])


def run(*command, **settings):
    outcome = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False, **settings)
    if outcome.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}\n{outcome.stdout[-4000:]}{outcome.stderr[-4000:]}")
    return outcome.stdout


with tempfile.TemporaryDirectory() as folder:
    here = pathlib.Path(folder)
    python = here / "env/bin/python"
    run(sys.executable, "-m", "venv", "--system-site-packages", here / "env")
    environment = {**os.environ, "PLUMBLINE_BUILD": str(build), "MPLBACKEND": "Agg"}
    environment.pop("PYTHONPATH", None)
    run(python, "-m", "pip", "install", "--quiet", "--no-build-isolation", "--no-index", source, source / "python/reference",
        env=environment)
    found = run(python, "-c", "import plumbline, plumbline_reference, pathlib; print(pathlib.Path(plumbline.__file__).parent);"
                "print(plumbline.critical_forces(*plumbline_reference.chains()['paper-two-link'])[0])", cwd=here)
    installed, force = found.split()
    assert installed.startswith(str(here)) and force == "2.0", found
    assert {"py.typed", "_engine.pyi"} <= {file.name for file in pathlib.Path(installed).iterdir()}
    # whoever uses the package is told of wrong types
    (here / "user.py").write_text("import plumbline\nplumbline.critical_forces([1, 1], [0, 1], digits='many')\n")
    typed = subprocess.run(["/usr/bin/python3", "-m", "mypy", "--python-executable", str(python), str(here / "user.py")],
                           cwd=here, capture_output=True, text=True, check=False)
    assert 'Argument "digits"' in typed.stdout and "1 error" in typed.stdout.splitlines()[-1], typed.stdout + typed.stderr
    # a kernel is the interpreter that starts it
    run(python, "-m", "ipykernel", "install", "--prefix", here / "env", "--name", "python3", env=environment)
    for notebook in sorted((source / "python/notebooks").glob("*.ipynb")):
        run(python, "-m", "nbconvert", "--to", "html", "--execute", "--output-dir", here, notebook,
            env={**environment, "JUPYTER_PATH": str(here / "env/share/jupyter")})
        assert (here / notebook.with_suffix(".html").name).stat().st_size > 10000
    run(python, "-m", "pip", "uninstall", "--quiet", "--yes", "plumbline", "plumbline-reference")
print("installed, used, removed")
