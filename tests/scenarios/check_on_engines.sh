#!/bin/sh
# check_on_engines.sh ARMATURE SCENARIO: checks the scenario on each engine of ARMATURE_SCENARIO_ENGINES, by default on the model.
set -eu
for engine in ${ARMATURE_SCENARIO_ENGINES:-model}; do
  "$1" check "$2" --engine "$engine"
done
