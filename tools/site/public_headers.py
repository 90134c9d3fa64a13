"""Writes the pages of the public interfaces: for each room, a page with the declarations of its public headers."""

import pathlib
import xml.etree.ElementTree as tree

# Breathe's directive for each kind of member of a namespace.
MEMBERS = {"function": "doxygenfunction", "enum": "doxygenenum", "typedef": "doxygentypedef", "variable": "doxygenvariable"}


def compounds(xml):
    """Returns the elements of all files, namespaces, classes and concepts that Doxygen found, by kind."""
    found = {}
    for file in sorted(xml.glob("*.xml")):
        for compound in tree.parse(file).getroot().findall("compounddef"):
            found.setdefault(compound.get("kind"), []).append(compound)
    return found


def place(element):
    """Returns the header and the line of a declaration."""
    location = element.find("location")
    return location.get("file"), int(location.get("line", 0))


def declarations(xml):
    """Returns {header: [(line, directive)]} of all declarations outside of classes."""
    found = compounds(xml)
    listed = {}
    classes = {compound.findtext("compoundname") for kind in ("class", "struct") for compound in found.get(kind, [])}
    for kind, directive in (("class", "doxygenclass"), ("struct", "doxygenstruct"), ("concept", "doxygenconcept")):
        for compound in found.get(kind, []):
            name = compound.findtext("compoundname")
            header, line = place(compound)
            if name.rpartition("::")[0] not in classes:
                members = "" if kind == "concept" else "\n:members:\n:undoc-members:"
                listed.setdefault(header, []).append((line, f":::{{{directive}}} {name}{members}\n:::"))
    for namespace in found["namespace"]:
        for member in namespace.iter("memberdef"):
            name = member.findtext("qualifiedname")
            if member.get("kind") not in MEMBERS or name in classes or "detail::" in name:  # a member with a class's name is a deduction guide
                continue
            arguments = member.findtext("argsstring") if member.get("kind") == "function" else ""
            header, line = place(member)
            listed.setdefault(header, []).append((line, f":::{{{MEMBERS[member.get('kind')]}}} {name}{arguments}\n:::"))
    return listed


def write_interface_pages(xml, folder):
    """Writes FOLDER/ROOM.md for each room whose headers Doxygen read, and FOLDER/README.md, which lists them."""
    folder.mkdir(parents=True)
    rooms = {}
    for header, listed in sorted(declarations(xml).items()):
        directives = [directive for line, directive in sorted(listed)]
        part = [f"## {header.split('/', 2)[2]}", f"```cpp\n#include <{header}>\n```", *directives]
        rooms.setdefault(pathlib.PurePath(header).parts[1], []).append("\n\n".join(part))
    for room, parts in rooms.items():
        (folder / f"{room}.md").write_text("\n\n".join([f"# {room}", *parts]) + "\n")
    links = "\n".join(f"- [{room}]({room}.md)" for room in rooms)
    (folder / "README.md").write_text(
        "# Interfaces in C++\n\nYour own programs may include these headers. "
        "[Building by hand](../../docs/start/commands.md#building-by-hand) says how to install the headers, and [own "
        f"processes](../../docs/guides/own-processes.md) has a first program.\n\n{links}\n")
