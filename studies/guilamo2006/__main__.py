"""`python -m studies.guilamo2006 [--quick] [--out DIR]`: all tables and figures of the study."""

import sys

from studies.guilamo2006.run import STUDY

if __name__ == "__main__":
    sys.exit(bool(STUDY.main()))
