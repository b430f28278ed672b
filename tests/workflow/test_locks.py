"""The lock files: every package pinned and hashed, no host named, in step with the `.in` files."""

import re
import tomllib

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

LOCKS = ["requirements-setup", "requirements", "requirements-test", "requirements-engines"]


def locked(text):
    """Return the versions of each package of a lock file (markers may ask for several)."""
    found: dict[str, list[str]] = {}
    for name, version in re.findall(r"^([\w.-]+)==([\w.]+)", text, re.MULTILINE):
        found.setdefault(canonicalize_name(name), []).append(version)
    return found


def asked(text):
    """Return the requirements of an `.in` file."""
    lines = (line.split(" #")[0].strip() for line in text.splitlines())
    return [Requirement(line) for line in lines if line and not line.startswith(("#", "-"))]


@pytest.mark.parametrize("name", LOCKS)
def test_no_host_is_named(root, name):
    text = (root / f"{name}.lock").read_text()
    assert re.findall(r".*(?:://|--(?!hash=)\S+).*", text) == []


@pytest.mark.parametrize("name", LOCKS)
def test_every_package_is_hashed(root, name):
    text = (root / f"{name}.lock").read_text()
    blocks = re.split(r"\n(?=\S)", text)
    assert [block.split()[0] for block in blocks if "--hash=sha256:" not in block] == []


@pytest.mark.parametrize("name", LOCKS)
def test_lock_is_in_step(root, name):
    versions = locked((root / f"{name}.lock").read_text())
    wishes = asked((root / f"{name}.in").read_text())
    late = [
        str(wish)
        for wish in wishes
        if not any(map(wish.specifier.contains, versions.get(canonicalize_name(wish.name), [])))
    ]
    assert wishes
    assert late == []


@pytest.mark.parametrize("name", LOCKS)
def test_every_wish_says_why(root, name):
    lines = (root / f"{name}.in").read_text().splitlines()
    assert [x for x in lines if re.match(r"\w", x) and " # " not in x] == []


@pytest.mark.parametrize("more", ["requirements-test", "requirements-engines"])
def test_what_comes_on_top_shares_the_versions_of_the_build(root, more):
    build = locked((root / "requirements.lock").read_text())
    tools = locked((root / f"{more}.lock").read_text())
    assert {name: tools[name] for name in build.keys() & tools} == {
        name: build[name] for name in build.keys() & tools
    }


def test_package_needs_nothing_that_is_not_locked(root):
    project = tomllib.loads((root / "pyproject.toml").read_text())["project"]
    build = locked((root / "requirements.lock").read_text())
    assert [x for x in project["dependencies"] if canonicalize_name(x) not in build] == []
