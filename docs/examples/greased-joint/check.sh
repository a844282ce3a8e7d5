#!/bin/sh
# After maintenance: check.sh BEFORE AFTER tells whether the device is as it was, and keeps the report.
plumbline diagnose "$2" --against "$1" --check --json=change.json > change.txt 2> refused.txt
case $? in
  0) echo "unchanged: back to work" ;;
  1) sed -n 3p change.txt; exit 1 ;;
  *) echo "cannot tell: $(cat refused.txt)"; exit 2 ;;
esac
