#!/usr/bin/env bash
# Holds the recipes of docs/ci against the published schemas of GitHub's workflows and of GitLab's pipelines.
# Usage: tools/scripts/checks/ci_recipes.sh        Status 77 where node, npm's packages or python3-yaml cannot be had
# (tools/setup.sh --with report --only tests).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
/usr/bin/python3 -c 'import yaml' 2>/dev/null || {
  printf 'ci_recipes: SKIPPED, python3-yaml is missing; run tools/setup.sh --only tests\n' >&2
  exit 77
}
MODULES=$(tools/scripts/report/packages.sh tests/ci/schemas)
export MODULES
node --test tests/ci/schemas/recipes.test.js
