"""The tables of grammars/mccl.lark.

Written by `python -m motionlang.lang.parsing.generate`, not by hand.
"""

# ruff: noqa
# mypy: ignore-errors
# fmt: off

import re

from motionlang.lang.parsing.parser import Automaton

PIECE = re.compile('(?>(?:;[^\n]*+|(?<![^\n])[ \t]*+#[^\n]*+|[, \t])*)(?:((?>(?:[^;, \t\\n"]++|"[^"\\n]*+(?:"|$))+))|$)', re.ASCII)

SEPARATORS = re.compile('(?>(?:[, \t])*)', re.ASCII)

COMMENT = re.compile('^(?>(?:(?!;[^\n]*+|(?<![^\n])[ \t]*+#[^\n]*+)(?:[, \t]|(?>(?:[^;, \t\\n"]++|"[^"\\n]*+(?:"|$))+)))*)(?=(;[^\n]*+|(?<![^\n])[ \t]*+#[^\n]*+))', re.ASCII)

COMMAND = re.compile('((?:[0-9]++(?=[A-Za-z])[A-Za-z][A-Za-z]|[A-Za-z][A-Za-z]))(?:(?:([+-]?[0-9]{1,18}+(?=[, \t\n;]|$))|([+-]?(?:[0-9]++(?:\\.[0-9]*+)?|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?(?=[, \t\n;]|$))|(@[0-9]{1,9}+(?=[, \t\n;]|$))|("[^"\n]*+"(?=[, \t\n;]|$))))?', re.ASCII)

TERMINALS = {
    'AXIS': '[0-9]++(?=[A-Za-z])',
    'MNEMONIC': '[A-Za-z][A-Za-z]',
    'WHOLE': '[+-]?[0-9]{1,18}+(?=[, \t\n;]|$)',
    'REAL': '[+-]?(?:[0-9]++(?:\\.[0-9]*+)?|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?(?=[, \t\n;]|$)',
    'REGISTER': '@[0-9]{1,9}+(?=[, \t\n;]|$)',
    'TEXT': '"[^"\n]*+"(?=[, \t\n;]|$)',
    '_SEPARATOR': '[, \t]',
    '_NEWLINE': '\\\n',
    'REMARK': ';[^\n]*+',
    'WHOLE_LINE': '(?<![^\n])[ \t]*+#[^\n]*+',
}

BEGINS = {'REGISTER': '@', 'TEXT': '"'}

RULES = (
    (0, 'start', None),
    (1, 'word', None),
    (1, '__start_star_0', None),
    (1, '___separators_plus_2', None),
    (1, '_separators', None),
    (1, 'start', None),
    (1, 'line', None),
    (1, 'line', None),
    (1, 'start', None),
    (1, 'command', None),
    (2, 'word', None),
    (2, '___separators_plus_2', None),
    (2, '__start_star_0', None),
    (2, 'start', None),
    (2, 'line', None),
    (2, 'line', None),
    (2, 'line', None),
    (2, '__start_star_0', None),
    (2, 'command', None),
    (3, '__start_star_0', None),
    (3, 'line', None),
    (3, 'line', None),
    (3, 'line', None),
    (2, '__line_star_1', None),
    (4, 'line', None),
    (3, '__line_star_1', None),
)

ROWS = (
    '1=AXIS 2=MNEMONIC 3=_NEWLINE 4=_SEPARATOR 5=___separators_plus_2 6=__start_star_0 7=_separators 8=command 9=line 10=start 11=word d0',
    '12=MNEMONIC',
    'd1',
    'd2',
    'd3',
    '13=_SEPARATOR d4',
    '1=AXIS 2=MNEMONIC 14=_NEWLINE 4=_SEPARATOR 5=___separators_plus_2 7=_separators 8=command 15=line 11=word d5',
    '1=AXIS 2=MNEMONIC 16=command 11=word d6',
    '4=_SEPARATOR 5=___separators_plus_2 17=__line_star_1 18=_separators d7',
    '19=_NEWLINE d8',
    '',
    '20=REAL,REGISTER,TEXT,WHOLE,parameter d9',
    'd10',
    'd11',
    'd12',
    '21=_NEWLINE d13',
    '4=_SEPARATOR 5=___separators_plus_2 22=__line_star_1 23=_separators d14',
    '4=_SEPARATOR 5=___separators_plus_2 24=_separators d15',
    '1=AXIS 2=MNEMONIC 25=command 11=word d16',
    'd17',
    'd18',
    'd19',
    '4=_SEPARATOR 5=___separators_plus_2 26=_separators d20',
    '1=AXIS 2=MNEMONIC 25=command 11=word d21',
    '1=AXIS 2=MNEMONIC 27=command 11=word d22',
    'd23',
    '1=AXIS 2=MNEMONIC 27=command 11=word d24',
    'd25',
)

AUTOMATON = Automaton(TERMINALS, RULES, ROWS, 10)
