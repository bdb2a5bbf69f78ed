"""`python -m studies.dufour2020 [--quick] [--out DIR]`: all tables and figures of the study."""

import sys

from studies.dufour2020.run import STUDY

if __name__ == "__main__":
    sys.exit(bool(STUDY.main()))
