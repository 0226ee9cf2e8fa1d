# SPDX-License-Identifier: MIT
"""The package gives the numbers that the program prints."""

import io
import json
import os
import pathlib
import subprocess

import numpy as np
import pytest

import orthoball
from orthoball import AlphaShapes

ROOT = pathlib.Path(__file__).resolve().parents[2]
SAMPLES = ROOT / "examples" / "data"
REFERENCE = ROOT.parent / "shared" / "reference" / "generated"
PROGRAM = os.environ.get("ORTHOBALL_PROGRAM", str(ROOT / "build" / "release" / "orthoball"))

pytestmark = pytest.mark.partner


def inputs():
    """(path, options of the program, options of read)."""
    yield SAMPLES / "c60.xyz", [], {}
    yield SAMPLES / "bdna_dodecamer.pdb", [], {}
    yield SAMPLES / "linked_tori.csv", [], {}
    yield SAMPLES / "trees.csv", ["--radius-column", "crown"], {"radius_column": "crown"}
    for path in sorted(REFERENCE.glob("*.txt")):
        words = dict(
            word.split("=") for word in path.read_text().split("\n")[0].split() if "=" in word
        )
        dimension = int(words["dim"])
        options, keywords = ["--dimension", str(dimension), "--allow-empty"], {}
        if words["weighted"] == "1":
            keywords["radius_column"] = dimension + 1
            options += ["--radius-column", str(dimension + 1)]
        yield path, options, {"dimension": dimension, "allow_empty": True, **keywords}


def as_json(number):
    """JSON has null for what is beyond the double range."""
    return number if number is None or np.isfinite(number) else None


@pytest.fixture(params=inputs(), ids=lambda given: given[0].stem)
def given(request):
    path, options, keywords = request.param

    def printed(command, *more):
        arguments = [PROGRAM, command, str(path), *options, *more, "--quiet"]
        return subprocess.run(arguments, capture_output=True, check=True).stdout

    return AlphaShapes(orthoball.read(path, **keywords)), printed


def test_summary(given):
    shapes, printed = given
    summary = json.loads(printed("summary", "--json"))
    reading, decimals = summary["input"], summary["input"]["decimals"]
    assert (shapes.site_count, shapes.decimals) == (reading["sites"], decimals)
    assert (shapes.dimension, shapes.affine_dimension) == (
        summary["dimension"], summary["affine_dimension"],
    )  # fmt: skip
    assert shapes.hidden.tolist() == summary["hidden"]
    assert shapes.duplicates.tolist() == summary["duplicates"]
    counts = [len(shapes.simplices(k).enters) for k in range(shapes.dimension + 1)]
    assert counts == summary["simplices"]
    assert len(shapes.spectrum) == summary["spectrum_size"]
    if len(shapes.spectrum) > 0:
        assert shapes.spectrum[[0, -1]].tolist() == [summary["alpha2_min"], summary["alpha2_max"]]
    for ours, theirs in zip(shapes.notable_alphas(), summary["notable"], strict=True):
        assert (ours.name, ours.reason, ours.index) == (
            theirs["name"], theirs["reason"], theirs["index"],
        )  # fmt: skip
        if ours.index is not None:
            assert (ours.alpha2, ours.alpha) == (theirs["alpha2"], theirs["alpha"])


def test_signatures(given):
    shapes, printed = given
    rows = json.loads(printed("signatures", "--json"))
    signatures = shapes.signatures
    assert len(signatures["index"]) == len(rows)
    for name, column in signatures.items():
        ours = column.tolist() if column.ndim > 1 else [as_json(x) for x in column.tolist()]
        assert ours == [row[name] for row in rows], name


def test_filter(given):
    shapes, printed = given
    archive = np.load(io.BytesIO(printed("filter", "--format", "npz")))
    filtration = shapes.filtration()
    never = len(shapes.spectrum) + 1
    for name in ("dimension", "vertices", "alpha2", "enters", "regular", "interior"):
        ours, theirs = getattr(filtration, name), archive[name]
        if name in ("regular", "interior"):
            theirs = np.where(theirs == 0, never, theirs)
        assert np.array_equal(ours, theirs), name
    assert np.array_equal(shapes.spectrum, archive["spectrum"])


def test_files_of_tables(given):
    shapes, printed = given
    everything = shapes.filtration()
    for format in ("csv", "json"):
        assert everything.to_bytes(format) == printed("filter", "--format", format)
        assert shapes.signatures.to_bytes(format) == printed("signatures", "--format", format)
    assert shapes.signatures.to_bytes("npz") == printed("signatures", "--format", "npz")
    balls = printed("signatures", "--balls", "--alpha2", "-1,0.25,auto", "--format", "csv")
    assert shapes.ball_signatures([-1, 0.25, "auto"]).to_bytes("csv") == balls


def test_persistence(given, tmp_path):
    shapes, printed = given
    plot, classes = tmp_path / "plot.svg", tmp_path / "classes.ply"
    pairs = printed("persistence", "--minimum-length", "0.5", "--plot", plot, "--plot-kind", "barcode",
                    "--representatives", classes)  # fmt: skip
    diagrams = shapes.persistence(minimum_length=0.5)
    assert diagrams.to_bytes("csv") == pairs
    assert diagrams.figure("barcode") == plot.read_bytes()
    assert diagrams.representatives().to_bytes("ply") == classes.read_bytes()
    all_pairs = printed("persistence", "--all", "--indices", "--format", "gudhi")
    assert shapes.persistence(all=True).to_bytes("gudhi", indices=True) == all_pairs
    holes = printed("persistence", "--homology-dimension", "1", "--format", "json")
    assert shapes.persistence(1).to_bytes("json") == holes


def test_representatives_at_an_alpha2(given, tmp_path):
    shapes, printed = given
    classes = tmp_path / "classes.json"
    printed("persistence", "--representatives", classes, "--representatives-alpha2", "1.5")
    found = shapes.persistence().representatives(alpha2=1.5)
    assert found.to_bytes("json") == classes.read_bytes()


def test_alpha_candidates(given):
    shapes, printed = given
    assert shapes.alpha_candidates().to_bytes("json") == printed("alpha", "--format", "json")
    resampled = printed("alpha", "--resamples", "2", "--seed", "5", "--format", "csv")
    assert shapes.alpha_candidates(resamples=2, seed=5).to_bytes("csv") == resampled


def test_manifold(given, tmp_path):
    shapes, printed = given
    changes = tmp_path / "changes.csv"
    surface = printed("shape", "--manifold", "--changes", changes, "--format", "obj")
    closed = shapes.shape().manifold()
    assert closed.to_bytes("obj") == surface
    assert closed.solid.to_bytes("csv") == changes.read_bytes()


def test_signature_figure(given, tmp_path):
    shapes, printed = given
    printed(
        "signatures", "--plot", tmp_path / "plot.svg", "--plot-axis", "index", "-o", tmp_path / "x"
    )
    assert shapes.signature_figure(axis="index") == (tmp_path / "plot.svg").read_bytes()


def test_weights_from_density(given):
    shapes, printed = given
    if shapes.weights is not None or len(shapes.duplicates) > 0 or shapes.site_count < 6:
        return
    try:
        dense = AlphaShapes(shapes._reading, weights="density:4")
    except orthoball.InputError:  # of numbers near the ends of the range of doubles
        with pytest.raises(subprocess.CalledProcessError):
            printed("filter", "--weights", "density:4")
        return
    assert dense.filtration().to_bytes("csv") == printed("filter", "--weights", "density:4")


def test_files_of_balls(given, tmp_path):
    shapes, printed = given
    if shapes.weights is not None and (shapes.weights < 0).any():
        return
    balls = shapes.balls(probe=1.4)
    names = ["per_atom", "contacts", "derivatives", "voids"]
    if "residue" in shapes._reading.labels:
        names += ["per_residue", "residue_contacts"]
    options = ["--cells", tmp_path / "cells.csv", "--cells-within", "balls"]
    for name in names:
        options += [f"--{name.replace('_', '-')}", tmp_path / f"{name}.csv"]
    has_script = shapes.dimension == 3 and shapes._reading.format in ("pdb", "xyz")
    shown = ["ply", "pml"] if has_script else ["ply"]
    for format in shown:
        options += ["--mesh" if format == "ply" else "--script", tmp_path / f"voids.{format}"]
    printed("measure", "--probe", "1.4", *options)
    for name in [*names, "cells"]:
        assert balls.to_bytes(name, "csv") == (tmp_path / f"{name}.csv").read_bytes(), name
    for format in shown:
        written = (tmp_path / f"voids.{format}").read_bytes()
        balls.write("voids", tmp_path / f"ours.{format}")
        assert (tmp_path / f"ours.{format}").read_bytes() == written
    pockets = printed(
        "pockets", "--probe", "1.4", "--format", "csv", "--mesh", tmp_path / "pockets.ply"
    )
    assert balls.to_bytes("pockets", "csv") == pockets
    assert balls.to_bytes("pockets", "ply") == (tmp_path / "pockets.ply").read_bytes()
    if shapes._reading.format == "pdb":
        printed("measure", "--probe", "1.4", "--pdb", tmp_path / "areas.pdb")
        assert balls.pdb() == (tmp_path / "areas.pdb").read_bytes()


@pytest.mark.parametrize("name", ["c60.xyz", "linked_tori.csv", "figure_eight.csv"])
def test_locate(samples, tmp_path, name):
    pytest.importorskip("pandas")
    shapes = AlphaShapes(orthoball.read(samples / name))
    queries = np.concatenate([shapes.points[:20] + 0.125, [shapes.points[0] * 100 + 1]])
    header = ",".join("xyz"[: shapes.dimension])
    np.savetxt(tmp_path / "query.csv", queries, "%.17g", ",", header=header, comments="")
    arguments = [PROGRAM, "locate", samples / name, tmp_path / "query.csv", "--json", "--quiet"]
    rows = json.loads(subprocess.run(arguments, capture_output=True, check=True).stdout)
    table = shapes.shape().locate(queries).to_pandas().reset_index()
    assert list(table) == list(rows[0])
    for ours, theirs in zip(table.to_dict("records"), rows, strict=True):
        for column, value in theirs.items():
            if value is None:
                assert ours[column] is None or ours[column] is pandas_na(), column
            else:
                assert ours[column] == value, column


def pandas_na():
    import pandas

    return pandas.NA


@pytest.mark.skipif(not orthoball.has_linear_solver(), reason="the solver CLP is not installed")
def test_enforce(samples, tmp_path):
    (tmp_path / "hedge.txt").write_text("14 5\n5 9\n2 17\n")
    arguments = [PROGRAM, "enforce", str(samples / "trees.csv"), str(tmp_path / "hedge.txt"),
                 "--columns", "x,y", "--alpha2", "25", "--add-sites", "--quiet"]  # fmt: skip
    printed = subprocess.run(arguments, capture_output=True, check=True).stdout
    shapes = AlphaShapes(orthoball.read(samples / "trees.csv", columns=["x", "y"]))
    cut = shapes.enforce([[14, 5], [5, 9], [2, 17]], alpha2=25, add_sites=True)
    assert cut.to_bytes("csv") == printed


def test_shape(given):
    shapes, printed = given
    shape = shapes.shape()
    assert shape.to_bytes("ply") == printed("shape", "--format", "ply")
    at = ("--index", str(len(shapes.spectrum) // 2))
    half = shapes.shape(index=len(shapes.spectrum) // 2)
    assert half.to_bytes("obj", roles=True) == printed("shape", "--format", "obj", "--roles", *at)
    if shapes.dimension == 2:
        assert half.to_bytes("geojson") == printed("shape", "--format", "geojson", *at)


@pytest.mark.parametrize("probe", [0, 1.4])
def test_measure_and_pockets(given, probe):
    shapes, printed = given
    if probe > 0 and shapes.weights is not None and (shapes.weights < 0).any():
        with pytest.raises(orthoball.InputError, match="row .* imaginary ball"):
            shapes.balls(probe=probe)
        return
    balls = shapes.balls(probe=probe)
    measured = json.loads(printed("measure", "--json", "--probe", str(probe)))
    for name in ("index", "volume", "area", "euler", "mean_curvature"):
        assert as_json(getattr(balls, name)) == measured[name], name
    assert list(balls.betti) == measured["betti"]
    for ours, theirs in zip(balls.voids, measured["voids"], strict=True):
        assert (as_json(ours.volume), as_json(ours.area)) == (theirs["volume"], theirs["area"])
        assert (
            ours.rows.tolist() == theirs["atoms"]
            and [as_json(x) for x in ours.areas] == theirs["atom_areas"]
        )
        assert (ours.born_alpha2, ours.dies_alpha2) == (theirs["born"], theirs["dies"])
    pockets = json.loads(printed("pockets", "--json", "--probe", str(probe)))["pockets"]
    for ours, theirs in zip(balls.pockets, pockets, strict=True):
        for name in ("volume", "area", "depth"):
            assert as_json(getattr(ours, name)) == theirs[name], name
        assert len(ours.mouths) == len(theirs["mouths"])
