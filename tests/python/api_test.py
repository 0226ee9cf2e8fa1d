# SPDX-License-Identifier: MIT
"""What the package offers: documented, typed, tested, and nothing else in the wheel."""

import ast
import inspect
import os
import pathlib
import re
import subprocess
import sys

import pytest

import orthoball
from orthoball import _core
from orthoball.compat import alphashape, gudhi, matlab

TESTS = pathlib.Path(__file__).resolve().parent
PACKAGE = pathlib.Path(orthoball.__file__).resolve().parent
ERRORS = (_core.InputError, _core.ParseError, _core.LimitError)
MODULES = [orthoball, alphashape, gudhi, matlab]


def public_classes():
    for module in MODULES:
        for name in getattr(module, "__all__", dir(module)):
            it = getattr(module, name)
            if inspect.isclass(it) and not name.startswith("_"):
                if module is orthoball or it.__module__ == module.__name__:
                    yield it


def members(cls):
    """Public names that a class defines itself."""
    return [name for name in vars(cls) if not name.startswith("_")]


def names():
    """Every public name: of modules, of classes, of the compiled part."""
    yield from orthoball.__all__
    for module in MODULES[1:]:
        for name, it in vars(module).items():
            if inspect.isfunction(it) and it.__module__ == module.__name__ and name[0] != "_":
                yield name
    for cls in public_classes():
        yield from members(cls)


def test_every_name_occurs_in_a_test():
    text = "\n".join(path.read_text() for path in TESTS.glob("*_test.py"))
    missing = [name for name in set(names()) if not re.search(rf"\b{name}\b", text)]
    assert not missing


def test_results_have_the_types_that_are_offered(samples):
    reading = orthoball.read(samples / "bdna_dodecamer.pdb")
    shapes = orthoball.AlphaShapes(reading)
    balls = shapes.balls(probe=1.4)
    (pocket,) = [pocket for pocket in balls.pockets if pocket.mouths][:1]
    results = {
        orthoball.Reading: reading,
        orthoball.Simplices: shapes.simplices(0),
        orthoball.Filtration: shapes.filtration(index=5),
        orthoball.Signatures: shapes.signatures_at(index=[5]),
        orthoball.Diagram: shapes.persistence(0),
        orthoball.Diagrams: shapes.persistence(),
        orthoball.Representatives: shapes.persistence(1).representatives(alpha2=0.0),
        orthoball.Representative: shapes.persistence(0).representative(0),
        orthoball.AlphaCandidates: shapes.alpha_candidates(),
        orthoball.AlphaCandidate: shapes.alpha_candidates()[0],
        orthoball.Solid: shapes.shape().manifold().solid,
        orthoball.NotableAlpha: shapes.automatic_alpha(),
        orthoball.Shape: shapes.shape(),
        orthoball.Nearest: shapes.shape().nearest(shapes.points[:1]),
        orthoball.Region: shapes.shape().regions()[0],
        orthoball.ShapeEdits: shapes.shape().edits,
        orthoball.PowerCells: shapes.power_cells(),
        orthoball.OutlineCurve: orthoball.AlphaShapes([[0, 0]], radii=1).balls().outline()[0],
        orthoball.Located: shapes.shape().locate(shapes.points[:1]),
        orthoball.Balls: balls,
        orthoball.Contacts: balls.contacts,
        orthoball.Derivatives: balls.derivatives,
        orthoball.MolecularSurface: balls.molecular_surface,
        orthoball.Pocket: pocket,
        orthoball.Mouth: pocket.mouths[0],
        orthoball.Void: orthoball.AlphaShapes(orthoball.read(samples / "c60.xyz")).balls().voids[0],
    }
    for kind, result in results.items():
        assert isinstance(result, kind)
        assert repr(result)


def test_errors_are_value_errors():
    for error in (*ERRORS, orthoball.ConflictError):
        assert issubclass(error, ValueError)
    with pytest.raises(orthoball.LimitError, match="memory"):
        raise orthoball.LimitError("out of memory")


def test_everything_that_is_compiled_is_used_by_the_package():
    text = "\n".join(path.read_text() for path in PACKAGE.rglob("*.py"))
    bound = [name for name in dir(_core) if not name.startswith("__")]
    for cls in vars(_core).values():
        if not inspect.isclass(cls) or cls in (_core.Reading, *ERRORS):
            continue
        bound += members(cls)
    missing = [name for name in set(bound) if not re.search(rf"\b{name}\b", text)]
    assert not missing


def test_everything_has_a_docstring():
    missing = []
    for cls in public_classes():
        if not inspect.getdoc(cls):
            missing.append(cls.__name__)
        fields = getattr(cls, "_fields", ()) or getattr(cls, "__dataclass_fields__", {})
        for name in members(cls):
            if name not in fields and not inspect.getdoc(vars(cls)[name]):
                missing.append(f"{cls.__name__}.{name}")
    for name in ("read", "input_formats", "has_linear_solver", "density_weights"):
        assert inspect.getdoc(getattr(orthoball, name))
    assert not missing


def test_fields_of_tables_have_docstrings():
    missing = []
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if not isinstance(node, ast.ClassDef) or node.name.startswith("_"):
                continue
            for this, after in zip(node.body, [*node.body[1:], None]):
                documented = isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant)
                if not isinstance(this, ast.AnnAssign) or node.name == "Sites" or documented:
                    continue
                name = ast.unparse(this.target)
                if not name.startswith("_"):
                    missing.append(f"{path.name}: {node.name}.{name}")
    assert not missing


def test_the_stub_is_that_of_the_module(tmp_path):
    pytest.importorskip("nanobind.stubgen")
    stub = tmp_path / "_core.pyi"
    command = [sys.executable, "-m", "nanobind.stubgen", "-m", "orthoball._core", "-o", str(stub)]
    subprocess.run(command, check=True, capture_output=True)
    assert (PACKAGE / "_core.pyi").read_text() == stub.read_text()
    assert (PACKAGE / "py.typed").exists()


def test_importing_imports_no_other_package_than_numpy():
    program = "import sys, numpy; before = set(sys.modules); import orthoball; print(*sys.modules - before)"
    program = program.replace("- before", ".keys() - before")
    printed = subprocess.run(
        [sys.executable, "-c", program], check=True, capture_output=True, text=True
    )
    allowed = {"orthoball", *sys.stdlib_module_names, "numpy", "typing_extensions"}
    assert {name.partition(".")[0] for name in printed.stdout.split()} <= allowed


@pytest.mark.partner
def test_the_wheel_needs_nothing_that_cannot_be_put_into_it():
    folder = pathlib.Path(
        os.environ.get("ORTHOBALL_WHEELS", TESTS.parents[1] / "build/python/dist")
    )
    (wheel,) = folder.glob("orthoball-*.whl")
    assert f"orthoball-{orthoball.__version__}-" in wheel.name
    command = [sys.executable, "-m", "auditwheel", "show", str(wheel)]
    shown = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    shown = re.sub(r"\s+", " ", shown)
    assert "manylinux" in shown
    outside = set(re.findall(r"(lib[\w+-]+)\.so", shown))
    # The first two are put into the wheel by `auditwheel repair`; the others are in every Linux.
    assert outside <= {"libtbb", "libz", "libc", "libm", "libgcc_s", "libstdc++", "libpthread"}
