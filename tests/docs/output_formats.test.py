"""The JSON that the program writes: it follows the schemas, and has every property that they name.

usage: output_formats.test.py PLUMBLINE
"""
import json
import math
import random
import shutil
import tempfile
from pathlib import Path

from jsonschema import Draft202012Validator

import two_links
from coverage import properties, used
from documents import ROOT, SCHEMAS
from program import plumbline

# Properties that no command below has reason to write: a certificate that fails.
RARE = {"gap-diagnosis": {"/calibration/left_of_unseen_poses/additionalProperties/turn",  # where orientations are read
                          "/law/laws/relaxation/time_constant", "/law/laws/relaxation/stiffness",
                          # tests of the report write these: report_text, report_json, draft_of_shapes
                          *(f"/cause/rest/{key}" for key in ("share", "noise_floor", "why")),
                          *(f"/gap/continued_runs/{key}" for key in ("run", "by")),
                          *(f"/gap/thinned/{key}" for key in ("run", "readings", "of")),
                          *(f"/gap/interpolated/{key}" for key in ("run", "covariate", "readings", "of"))},
        "motion-report": {"/next", *(f"/next/{key}" for key in ("motion", "gain", "apart")),
                          # a test of the diagnosis has these: motion/diagnosis
                          *(f"/beside/{key}" for key in ("effect", "words", "probability"))},
        "path": {"/certificates/failure/load", "/certificates/failure/reason"}}


def schema_of(name):
    schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text(encoding="utf-8"))
    Draft202012Validator.check_schema(schema)
    return schema


def written(*arguments, folder, statuses=(0,)):
    done = plumbline(*arguments, "--json", folder=folder)
    assert done.returncode in statuses, f"{arguments}: exit status {done.returncode}\n{done.stderr}"
    return json.loads(done.stdout)


def hold(name, instances):
    schema = schema_of(name)
    validator = Draft202012Validator(schema)
    seen = set()
    for instance in instances:
        validator.validate(instance)
        seen |= set(used(schema, instance))
    named = set(properties(schema))
    assert seen <= named
    missing = named - seen - RARE.get(name, set())
    assert not missing, f"{name}: no command writes {sorted(missing)}"


def straight_chains(folder):
    (folder / "chains.csv").write_text("chain,lengths,stiffness\na,1;1,1;1\nb,1;1;1,0;1;1\nb,1;1,1;1\n", encoding="utf-8")
    (folder / "good.csv").write_text("chain,lengths,stiffness\na,1;1,1;1\n", encoding="utf-8")
    (folder / "values.csv").write_text("chain,mode,force\na,1,2.4\n", encoding="utf-8")
    two_axes = "{ axes = [[0, 0, 1], [0, 1, 0]], stiffness = [1, 3] }"
    in_space = f"lengths = [1, 1]\njoints = [{two_axes}, {two_axes}]\n"
    (folder / "space.toml").write_text(in_space, encoding="utf-8")
    alike = "{ axes = [[0, 0, 1], [0, 1, 0]], stiffness = [1, 1] }"
    (folder / "twisted.toml").write_text(f"lengths = [1, 1, 1]\njoints = [{alike}, {alike}, {alike}]\n" + 'end_point = "clamped"\nloads = [{ torque = "semitangential" }]\n', encoding="utf-8")
    (folder / "ziegler.toml").write_text('lengths = [1, 1]\nstiffness = [1, 1]\nend_point = "free"\nloads = [{ follower = 1 }]\n',
                                         encoding="utf-8")
    (folder / "beck.toml").write_text('beam = { EI = 1, length = 1, links = 3 }\nbase = "clamped"\nend_point = "free"\n'
                                      'loads = [{ follower = 1 }]\n', encoding="utf-8")
    (folder / "touching.toml").write_text('lengths = [1, 1]\nstiffness = [1, 1]\nend_point = "free"\nmasses = [2, 1]\n'
                                          "loads = [{ follower = 5 }, { force = [-4, 0] }]\n", encoding="utf-8")
    chains = ("space.toml", "twisted.toml", "ziegler.toml", "touching.toml", "beck.toml")
    hold("critical", [written("critical", folder=folder), *(written("critical", name, folder=folder) for name in chains),
                      written("critical", "chains.csv", "--all", "--digits", "30", folder=folder, statuses=[2])])
    hold("check", [written("check", "values.csv", "--chains", "good.csv", folder=folder, statuses=[1])])


def claims(folder):
    hold("verify", [written("verify", "--section", "4.2", folder=folder)])


def loaded_chains(folder):
    (folder / "three.toml").write_text("lengths = [1, 1, 1]\nstiffness = [1, 1, 1]\n", encoding="utf-8")
    (folder / "two.toml").write_text("lengths = [1, 1]\nstiffness = [1, 1]\nrest = [0.3, -0.5]\n", encoding="utf-8")
    (folder / "nearly.toml").write_text("lengths = [1, 1]\nstiffness = [1.5, 1]\nrest = [0, 1e-30]\n", encoding="utf-8")
    hold("equilibria", [written("equilibria", "two.toml", "--at", "0.1,0", folder=folder),
                        written("equilibria", "two.toml", "--force", "-0.5,0.1", "--certify", folder=folder),
                        written("equilibria", "three.toml", "--end-point", "2.7,0", "--certify", folder=folder)])
    hold("path", [written("path", "--to", "1.5", "--digits", "20", "--certify", folder=folder),
                  written("path", "two.toml", "--force", "-1,0.2", folder=folder),
                  written("path", "nearly.toml", "--force", "-0.6,0", "--certify", folder=folder),
                  written("path", "three.toml", "--to", "0.5", "--branches", "all", "--certify", folder=folder,
                          statuses=[0, 1])])


def dragged():
    """A joint whose torque ripples, and which drags against its motion."""
    last = {}

    def law(joint, d, k):
        way = d - last.get(joint, 0)
        last[joint] = d
        if joint == 0 or way == 0:
            return k * d
        return k * d + 0.2 * math.sin(12 * d) + math.copysign(0.15, way)
    return law


def column(folder):
    """A straight link on a spring of 2 N m under a force along it, and past its critical one beside it to one side."""
    folder.mkdir()
    length, k, crooked = 0.5, 2.0, 2e-3
    (folder / "experiment.toml").write_text(
        f'format = "chain-experiment/1"\nname = "column"\n[nominal]\nlink_length = [{length}]\n'
        f'joint_stiffness = [{k}]\n[bench]\ngravity_plane = "horizontal"\n[noise]\nx = 1e-4\ny = 1e-4\n'
        '[[run]]\nid = "press"\ncontrol = "force"\nrest = [0]\nsamples = "press.csv"\n', encoding="utf-8")
    lines, q = ["t,x,y,Fx,Fy"], crooked
    for t in range(40):
        force = 1.6 * k / length * t / 39
        for _ in range(500):  # downhill: k (q - crooked) = F L sin q
            q -= 0.2 * (q - crooked - force * length / k * math.sin(q))
        lines.append(f"{t},{length * math.cos(q):.6f},{length * math.sin(q):.6f},{-force:.6f},0")
    (folder / "press.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def filmed(folder):
    """Three rigid joints of a model without masses, whose tip a camera of unknown pose and focal length sees, and a gauge above the floor."""
    folder.mkdir()
    (folder / "experiment.toml").write_text(
        'format = "chain-experiment/1"\nname = "filmed"\n[arm]\nframes = "unknown"\ntip_xyz = [0.4, 0, 0]\n'
        '[[arm.joint]]\n[[arm.joint]]\nxyz = [0, 0, 0.3]\naxis = [0, 1, 0]\n[[arm.joint]]\nxyz = [0.5, 0, 0]\naxis = [0, 1, 0]\n'
        '[[arm.sensor]]\nname = "eye"\nkind = "camera"\nxyz = [2, 0.1, 0.4]\n'
        '[[arm.sensor]]\nname = "floor"\nkind = "plane"\n[noise]\npixel = 0.05\nheight = 1e-5\n[[run]]\nid = "seen"\nsamples = "seen.csv"\n', encoding="utf-8")
    noise, lines = random.Random(1), ["q_command1,q_command2,q_command3,eye_u,eye_v,floor"]
    for _ in range(60):
        turn, shoulder, elbow = (noise.uniform(-0.8, 0.8) for _ in range(3))
        out = 0.5 * math.cos(shoulder) + 0.4 * math.cos(shoulder + elbow)
        x, y, z = out * math.cos(turn), out * math.sin(turn), 0.3 - 0.5 * math.sin(shoulder) - 0.4 * math.sin(shoulder + elbow)
        u, v = (1400 * side / (2 - x) + noise.gauss(0, 0.05) for side in (y - 0.1, 0.4 - z))
        lines.append(f"{turn:.6f},{shoulder:.6f},{elbow:.6f},{u:.4f},{v:.4f},{z + noise.gauss(0, 1e-5):.6f}")
    (folder / "seen.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return written("diagnose", folder.name, folder=folder.parent)


def reports(folder):
    linear = lambda joint, d, k: k * d
    rippled = lambda joint, d, k: k * d + (0.12 * math.sin(25 * d) if joint == 1 else 0)
    two_links.write(folder / "no-gap", linear, control=("displacement", "force"), angles=True)
    two_links.write(folder / "rough", linear, control=("displacement",) * 3, rough=1)
    two_links.write(folder / "partly-rough", linear, control=("displacement",) * 3, rough=2, rough_from=25)
    two_links.write(folder / "hum", linear, hum=3)
    two_links.write(folder / "ripple", rippled, control=("displacement", "displacement"), angles=True, readings=60)
    two_links.write(folder / "drag", dragged(), control=("displacement", "displacement"), angles=True, readings=60)
    two_links.write(folder / "one-spring", lambda joint, d, k: 1.3 * k * d, stiffness=(0.0, 1.5))
    verdicts = {}
    for name in ("no-gap", "ripple", "drag", "one-spring"):
        verdicts[name] = written("diagnose", name, "--corrected", f"{name}.xml", folder=folder)
    column(folder / "column")
    on_its_side = written("diagnose", "column", folder=folder)
    assert [one["run"] for one in on_its_side["gap"]["other_branch"]] == ["press"]
    rough = written("diagnose", "rough", folder=folder)
    assert [one["run"] for one in rough["gap"]["noisier_runs"]] == ["run-1"]
    assert not rough["gap"]["present"]
    partly = written("diagnose", "partly-rough", folder=folder)
    assert [one["run"] for one in partly["gap"]["noisier_segments"]] == ["run-2"]
    assert not partly["gap"]["present"]
    humming = written("diagnose", "hum", folder=folder)
    assert [one["channel"] for one in humming["gap"]["periodic_interference"]] == ["Fx", "Fy"]
    two_links.write(folder / "slip", linear, control=("displacement", "displacement"))
    place, lines = folder / "slip" / "run-1.csv", (folder / "slip" / "run-1.csv").read_text(encoding="utf-8").splitlines()
    t, x, y, Fx, Fy = lines[12].split(",")
    lines[12] = ",".join((t, x, y, str(float(Fx) + 50 * two_links.SIGMA["Fx"]), Fy))
    place.write_text("\n".join(lines) + "\n", encoding="utf-8")
    slip = written("diagnose", "slip", folder=folder)
    assert [(one["run"], one["reading"], one["channel"]) for one in slip["gap"]["outliers"]] == [("run-1", 11, "Fx")]
    assert slip["cause"]["verdict"] == "none"
    bundled = written("diagnose", "--next", "--corrected", "corrected.toml", folder=folder)
    found = {name: report["cause"]["verdict"] for name, report in verdicts.items()}
    assert found == {"no-gap": "none", "ripple": "unknown", "drag": "unknown", "one-spring": "ambiguous"}, found
    # One file a candidate, and none that is not said.
    for name, report in verdicts.items():
        files = {path.name for path in folder.glob(f"{name}*.xml")}
        assert files == {one["file"] for one in report["corrected"]}, name
        assert (len(files) > 1) == (report["cause"]["verdict"] == "ambiguous"), files
    assert bundled["cause"]["verdict"] == "identified"
    edited = written("diagnose", "no-gap", "--model", "no-gap.xml", "--corrected", "edited.xml", folder=folder)
    arm = written("diagnose", str(SCHEMAS.parent / "examples" / "arm"), folder=folder)
    greased = SCHEMAS.parent / "examples" / "greased-joint"
    changed = written("diagnose", str(greased / "greased"), "--against", str(greased / "dry"), folder=folder)
    hold("change-plan", [written("diagnose", str(greased / "dry"), "--plan", "--change", f"joint_friction={size}", folder=folder)
                         for size in (0.05, 1e-6)])
    shutil.copytree(SCHEMAS.parent / "examples" / "arm", folder / "anywhere")
    settings = (folder / "anywhere" / "experiment.toml").read_text(encoding="utf-8")
    (folder / "anywhere" / "experiment.toml").write_text(settings.replace("[arm]\n", "[arm]\nframes = \"unknown\"\n", 1), encoding="utf-8")
    anywhere = written("diagnose", "anywhere", folder=folder)
    hold("gap-diagnosis", [changed, anywhere, *verdicts.values(), on_its_side, rough, partly, humming, slip, bundled, edited, arm,
                           filmed(folder / "filmed"), written("diagnose", str(SCHEMAS.parent / "examples" / "draw-wires"), folder=folder)])


def trial(folder):
    cases = folder / "cases"
    cases.mkdir()
    two_links.write(cases / "quiet", lambda joint, d, k: k * d)
    (cases / "quiet" / "label.json").write_text('{"effects": []}', encoding="utf-8")
    two_links.write(cases / "stiff", lambda joint, d, k: (1.4 if joint == 1 else 1) * k * d)
    (cases / "stiff" / "label.json").write_text(
        '{"effects": [{"id": "joint_stiffness", "joint": 2, "parameters": {"a": 0.4}, "strength_sigma": 20}],'
        ' "strength_sigma": 20}', encoding="utf-8")
    hold("trial", [written("trial", "--experiments", "cases", folder=folder)])


def many(folder):
    """Of one experiment on three days, one that is broken, and two whose causes differ."""
    for day in (1, 2, 3):
        place = shutil.copytree(ROOT / "docs/examples" / "experiment", folder / f"day-{day}")
        settings = (place / "experiment.toml").read_text(encoding="utf-8")
        (place / "experiment.toml").write_text(f"date = 2026-03-0{day}\n{settings}", encoding="utf-8")
    two_links.write(folder / "one-spring", lambda joint, d, k: 1.3 * k * d, stiffness=(0.0, 1.5))
    (folder / "broken").mkdir()
    for day, state in ((1, "dry"), (2, "greased")):
        place = shutil.copytree(ROOT / "docs/examples" / "greased-joint" / state, folder / f"joint-{day}")
        settings = (place / "experiment.toml").read_text(encoding="utf-8")
        (place / "experiment.toml").write_text(f"date = 2026-03-0{day}\n{settings}", encoding="utf-8")
    hold("gap-campaign", [written("diagnose", "joint-1", "joint-2", "--since", folder=folder),
                          written("diagnose", "day-1", "day-2", "day-3", folder=folder),
                          written("diagnose", "day-1", "one-spring", "broken", folder=folder, statuses=[1])])


def plans(folder):
    two_links.write(folder / "planned", lambda joint, d, k: k * d, readings=8)
    hold("experiment-plan", [written("diagnose", "planned", "--plan", folder=folder)])


def motions(folder):
    """Of one log that was run twice, beside whose positions a duty without sign was read; and of a pendulum's torques."""
    place = shutil.copytree(ROOT / "docs/examples/servo-log", folder / "servo-log")
    header, *rows = (place / "chirp-16.csv").read_text(encoding="utf-8").split()
    for again in (1, 2):
        lines = [f"{header},duty", *(f"{row},{abs(float(row.split(',')[1])) / 5}" for row in rows)]
        (place / f"run-{again}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    settings = (place / "experiment.toml").read_text(encoding="utf-8")
    logs = settings[settings.index("[logs]"):settings.index("[servo]")]
    settings = settings.replace(logs, '[logs]\nfiles = ["run-1.csv", "run-2.csv"]\n\n[columns]\nduty = "duty"\n\n')
    settings = settings.replace('gain = "gain"', "gain = 16").replace("[noise]\n", "[noise]\nduty = 0.01\n")
    (place / "experiment.toml").write_text(settings, encoding="utf-8")
    hold("motion-report", [written("diagnose", "servo-log", folder=folder)])
    settings = settings.replace('"unknown"', "0.05").replace("[noise]", "[[motion]]\nkind = \"ramp\"\nsize = 0.6\n\n[noise]")
    (place / "experiment.toml").write_text(settings, encoding="utf-8")
    hold("motion-plan", [written("diagnose", "servo-log", "--plan", folder=folder)])
    hold("torque-report", [written("diagnose", str(pendulum(folder)), folder=folder)])


def pendulum(folder):
    """Readings of the torque that swings a point mass on a massless link."""
    place = folder / "pendulum"
    place.mkdir()
    inertial = '<inertial pos="0 0 -0.3" mass="0.5" diaginertia="1e-6 1e-6 1e-6"/>'
    (place / "arm.xml").write_text(f'<mujoco><worldbody><body name="link"><joint name="hinge" axis="0 1 0"/>{inertial}</body></worldbody></mujoco>',
                                   encoding="utf-8")
    rows = ["t,q,tau"]
    for k in range(1000):
        t = 0.01 * k
        q = 0.8 * math.sin(2 * t) + 0.4 * math.sin(5.1 * t)
        a = -0.8 * 4 * math.sin(2 * t) - 0.4 * 5.1**2 * math.sin(5.1 * t)
        v = 1.6 * math.cos(2 * t) + 0.4 * 5.1 * math.cos(5.1 * t)
        torque = 0.5 * 0.09 * a + 0.5 * 9.81 * 0.3 * math.sin(q) + 0.05 * math.copysign(1, v) + 0.002 * math.sin(1e4 * t)
        rows.append(f"{t:.3f},{q:.6f},{torque:.6f}")
    (place / "a.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    (place / "experiment.toml").write_text(
        'format = "torque/1"\nname = "pendulum"\n[model]\nfile = "arm.xml"\n[logs]\nfiles = ["a.csv"]\n[columns]\nposition = ["q"]\n'
        'torque = ["tau"]\n', encoding="utf-8")
    return place


with tempfile.TemporaryDirectory() as place:
    for step in (straight_chains, claims, loaded_chains, reports, plans, trial, many, motions):
        (Path(place) / step.__name__).mkdir()
        step(Path(place) / step.__name__)
