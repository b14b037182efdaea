#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes one HTML text of the page's modules, and of that a C++ source.

    bundle_page.py FOLDER OUTPUT.cpp [OUTPUT.html]

FOLDER/page.html has a line "<!--style-->" and a line "<!--script-->". The script is the modules of FOLDER, each after
those that it imports, as one module: `import` lines are left out, and `export` before a declaration. So a name stands
for one thing in all of them, which is checked.
"""
import pathlib
import re
import sys

IMPORT = re.compile(r"^import\s[^;]*?from\s+['\"]\./([\w.-]+)['\"];\n", re.M)
EXPORT = re.compile(r"^export (?=(async function|function|const|let|class) )", re.M)
DECLARED = re.compile(r"^(?:async function|function|const|let|class) (\w+)", re.M)


def modules_in_order(folder, name, done):
    if name in done:
        return
    text = (folder / name).read_text(encoding="utf-8")
    done[name] = None  # a cycle would come back here
    for imported in IMPORT.findall(text):
        if imported in done and done[imported] is None:
            sys.exit(f"{folder / name}: imports {imported}, which imports it")
        modules_in_order(folder, imported, done)
    del done[name]
    done[name] = EXPORT.sub("", IMPORT.sub("", text))


def bundled_script(folder):
    modules = {}
    modules_in_order(folder, "main.js", modules)
    declared_in = {}
    for name, text in modules.items():
        if re.search(r"^(import|export)\b", text, re.M):
            sys.exit(f"{folder / name}: an import or export of a form that bundle_page.py does not know")
        for word in DECLARED.findall(text):
            if word in declared_in:
                sys.exit(f"{folder / name}: {word} is declared in {declared_in[word]} too")
            declared_in[word] = name
    script = "\n".join(f"// {name}\n{text}" for name, text in modules.items())
    if "</script" in script:
        sys.exit(f"{folder}: a script must not hold '</script'")
    return script


def main(arguments):
    if len(arguments) not in (2, 3):
        sys.exit(__doc__)
    folder = pathlib.Path(arguments[0])
    page = (folder / "page.html").read_text(encoding="utf-8")
    for mark, text in (("<!--style-->", (folder / "page.css").read_text(encoding="utf-8")),
                       ("<!--script-->", bundled_script(folder))):
        if page.count(mark) != 1:
            sys.exit(f"{folder / 'page.html'}: {mark} must stand there once")
        page = page.replace(mark, text)
    # A string literal may be limited to 64 KiB: pieces stand side by side.
    pieces = [page[i:i + 8000] for i in range(0, len(page), 8000)]
    literal = "\n".join(f'R"keikan({piece})keikan"' for piece in pieces)
    pathlib.Path(arguments[1]).write_text(
        "// SPDX-License-Identifier: GPL-3.0-or-later\n// Made by bundle_page.py.\n"
        '#include "report/page_template.hpp"\n\n'
        f"const std::string_view keikan::report::kPageTemplate =\n{literal};\n", encoding="utf-8")
    if len(arguments) == 3:
        pathlib.Path(arguments[2]).write_text(page, encoding="utf-8")


main(sys.argv[1:])
