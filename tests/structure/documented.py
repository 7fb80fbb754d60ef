#!/usr/bin/env python3
"""Doxygen finds no undocumented public member in what programs include, values of enumerations and free functions as well."""

import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import house

# Doxygen's own warnings tell of members of classes.
FREE = ("file", "namespace")


def described(element):
    return any("".join(element.find(kind).itertext()).strip() for kind in ("briefdescription", "detaileddescription"))


def undocumented(member, is_free):
    """The names of what nobody describes, where Doxygen does not warn: free members, and values of public enumerations."""
    name = member.findtext("qualifiedname") or member.findtext("name")
    if member.get("prot") != "public":
        return
    if is_free and not described(member):
        yield name
    for value in member.findall("enumvalue"):
        if not described(value):
            yield f"{name}::{value.findtext('name')}"


def main():
    with tempfile.TemporaryDirectory() as folder:
        settings = (house.ROOT / "tests/structure/Doxyfile").read_text() + f"OUTPUT_DIRECTORY = {folder}\n"
        done = subprocess.run(["doxygen", "-"], cwd=house.ROOT, input=settings, capture_output=True, text=True)
        if done.returncode:
            sys.exit(f"doxygen ended with {done.returncode}:\n{done.stderr}")
        members, faults = set(), done.stderr.splitlines()
        for page in pathlib.Path(folder, "xml").glob("*.xml"):
            for compound in ElementTree.parse(page).getroot().findall("compounddef"):
                for member in compound.iter("memberdef"):
                    if member.get("id") not in members:
                        members.add(member.get("id"))
                        location = member.find("location")
                        at = f"{location.get('file')}:{location.get('line')}"
                        faults += [f"{at}: {name} is not documented" for name in undocumented(member, compound.get("kind") in FREE)]
        house.report(len(members), "members", sorted(set(faults)))


if __name__ == "__main__":
    sys.exit(main())
