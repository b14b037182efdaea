#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""usage: validate_lines.py SCHEMA LINES    One JSON document a line; prints "valid" or "invalid" for each.
Exits with 77 where python3-jsonschema is not installed."""
import json
import sys

try:
    import jsonschema
except ImportError:
    sys.exit(77)

with open(sys.argv[1]) as file:
    schema = json.load(file)
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
with open(sys.argv[2]) as lines:
    for line in lines:
        print("valid" if validator.is_valid(json.loads(line)) else "invalid")
