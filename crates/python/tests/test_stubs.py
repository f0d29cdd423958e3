"""The type stubs name what there is, and everything has a docstring."""

import ast
from pathlib import Path

import seamwright


def members(stub):
    """Names of the stub: functions and classes with their members and parameters."""
    found = {}
    for item in ast.parse(stub).body:
        if isinstance(item, ast.FunctionDef):
            found[item.name] = [a.arg for a in item.args.args + item.args.kwonlyargs]
        elif isinstance(item, ast.ClassDef):
            found[item.name] = {}
            for member in item.body:
                if isinstance(member, ast.FunctionDef):
                    arguments = [a.arg for a in member.args.args + member.args.kwonlyargs if a.arg not in ("self", "cls")]
                    found[item.name][member.name] = arguments
                elif isinstance(member, ast.AnnAssign):
                    found[item.name][member.target.id] = []
        elif isinstance(item, ast.AnnAssign):
            found[item.target.id] = []
    return found


def arguments_of(function):
    import inspect

    return [name for name in inspect.signature(function).parameters if name not in ("self", "cls")]


def test_stubs_agree_with_the_package():
    stub = members((Path(seamwright.__file__).parent / "__init__.pyi").read_text())
    assert sorted(stub) == sorted(seamwright.__all__)
    for name, content in stub.items():
        real = getattr(seamwright, name)
        if isinstance(content, list):
            assert not callable(real) or arguments_of(real) == content, name
            continue
        if issubclass(real, Exception):
            continue
        public = {m for m in vars(real) if not m.startswith("_")}
        assert public == {m for m in content if not m.startswith("_")}, name
        for member, arguments in content.items():
            method = getattr(real, member)
            if callable(method) and not member.startswith("_"):
                assert arguments_of(method) == arguments, f"{name}.{member}"


def test_everything_has_a_docstring():
    for name in seamwright.__all__:
        real = getattr(seamwright, name)
        if not callable(real):
            continue
        assert real.__doc__, name
        if isinstance(real, type) and not issubclass(real, Exception):
            for member in vars(real):
                assert member.startswith("_") or getattr(real, member).__doc__, f"{name}.{member}"
