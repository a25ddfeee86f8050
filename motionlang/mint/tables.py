"""The tables of grammars/mint.lark; written by `python -m motionlang.lang.grammar`, not by hand."""

# ruff: noqa
# mypy: ignore-errors

from motionlang.lang.tables import Tables
from motionlang.mint.build import *
from motionlang.mint.nodes import *


def _label_before_0(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = label_before(v0, v1, T)


def _end_1(V, T):
    v0 = V[-1]
    V[-1] = End(v0, None if None is None else T[None])


def _skip_2(V, T):
    V.pop()


def _body_3(V, T):
    V.append(body(V))


def _event_4(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = Event(v0, T[v1], v3)


def _pause_5(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Pause(v0, v1)


def _name_empty_6(V, T):
    V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Name(v0, T[v0], [])


def _not_7(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "Not", v1)


def _name_args_8(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Name(v0, T[v0], v2)


def _print_item_9(V, T):
    v2 = V.pop()
    v1 = V.pop()
    V[-1].append(PrintItem(v1.at, v1, [], T[v2]))


def _minus_10(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "-", v1)


def _auto_11(V, T):
    v0 = V[-1]
    V[-1] = Auto(v0)


def _select_12(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Select(v0, v2, [v4])


def _none_13(V, T):
    V.append([])


def _more_14(V, T):
    V.pop()
    v1 = V.pop()
    V[-1].append(v1)


def _module_15(V, T):
    v0 = V[-1]
    V[-1] = module(v0)


def _return_16(V, T):
    v0 = V[-1]
    V[-1] = Return(v0)


def _member_17(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Member(v0.at, v0, T[v2])


def _character_18(V, T):
    v0 = V[-1]
    V[-1] = Number(v0, ord(string(T[v0])))


def _bare_call_19(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Call(v0, Name(v0, T[v0], v1))


def _next_case_20(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = next_case(v0, v1, v2)


def _one_21(V, T):
    v0 = V[-1]
    V[-1] = [v0]


def _complement_22(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "~", v1)


def _parameter_by_value_23(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v1], None, False, None is not None)


def _exit_24(V, T):
    v0 = V[-1]
    V[-1] = Exit(v0, "" if None is None else T[None].lower())


def _run_25(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Run(v0, T[v1])


def _number_26(V, T):
    v0 = V[-1]
    V[-1] = Number(v0, number(T[v0]))


def _plus_27(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Unary(v0, "+", v1)


def _label_28(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Label(v0, T[v1])


def _case_else_29(V, T):
    V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Case(v0, [], [])


def _last_case_30(V, T):
    v0 = V[-4]
    v1 = V[-3]
    del V[-3:]
    V[-1] = last_case(v0, v1)


def _member_args_31(V, T):
    v0 = V[-6]
    v2 = V[-4]
    v4 = V[-2]
    del V[-5:]
    V[-1] = Member(v0.at, v0, T[v2], v4)


def _dim_32(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Dim(v0, v2, v1 is not None)


def _string_33(V, T):
    v0 = V[-1]
    V[-1] = String(v0, string(T[v0]))


def _print_34(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Print(v0, v1 if None is None else [*v1, None], None)


def _print_35(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Print(v0, v1 if v2 is None else [*v1, v2], None)


def _dim_36(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Dim(v0, v1, None is not None)


def _gosub_37(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "gosub", T[v2])


def _input_38(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Input(v0, v1, None if None is None else String(None, string(T[None])), None or [], None)


def _name_axes_39(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Name(v0, T[v0], v2, True)


def _goto_40(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "goto", T[v1])


def _exit_41(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Exit(v0, "" if v1 is None else T[v1].lower())


def _parameter_by_value_42(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], v3, False, None is not None)


def _goto_43(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "goto", T[v2])


def _plain_variable_44(V, T):
    v0 = V[-1]
    V[-1] = [declare(v0)]


def _last_item_45(V, T):
    v0 = V[-1]
    V[-1] = PrintItem(v0.at, v0, [], "")


def _name_46(V, T):
    v0 = V[-1]
    V[-1] = Name(v0, T[v0])


def _none_47(V, T):
    V[-1] = []


def _parameter_by_value_48(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], None, False, v2 is not None)


def _end_49(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = End(v0, None if v1 is None else T[v1])


def _gosub_50(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Jump(v0, "gosub", T[v1])


def _inner_51(V, T):
    V.pop()
    v1 = V.pop()
    V[-1] = v1


def _dotted_52(V, T):
    v0 = V[-1]
    V[-1] = dotted(v0, T[v0])


def _call_53(V, T):
    v0 = V[-1]
    V[-1] = Call(v0.at, v0)


def _binary_54(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, T[v1], v0, v2)


def _assign_55(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Assign(v0.at, v0, v2, None is not None)


def _parameter_by_reference_56(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v2 = V[-4]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Parameter(v0, T[v1], v5, True, v2 is not None)


def _for_57(V, T):
    v0 = V[-12]
    v1 = V[-11]
    v3 = V[-9]
    v5 = V[-7]
    v7 = V[-5]
    v9 = V[-3]
    del V[-11:]
    V[-1] = For(v0, Name(v1, T[v1]), v3, v5, v7, v9)


def _more_58(V, T):
    v2 = V.pop()
    V.pop()
    V[-1].append(v2)


def _extend_59(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = extended(v0, v1)


def _xor_60(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Xor", v0, v2)


def _input_61(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Input(v0, v3, None if v1 is None else String(v1, string(T[v1])), None or [], None)


def _parameter_by_reference_62(V, T):
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v1], None, True, None is not None)


def _parameter_63(V, T):
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], None, False, None is not None)


def _input_64(V, T):
    v0 = V[-7]
    v2 = V[-5]
    v4 = V[-3]
    v6 = V[-1]
    del V[-6:]
    V[-1] = Input(v0, v6, None if v4 is None else String(v4, string(T[v4])), None or [], v2)


def _assign_65(V, T):
    v0 = V[-4]
    v2 = V[-2]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Assign(v0.at, v0, v2, v3 is not None)


def _input_66(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Input(v0, v4, None if None is None else String(None, string(T[None])), None or [], v2)


def _loop_67(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Loop(v0, v2)


def _more_values_68(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = more_values(v0, v2)


def _print_69(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Print(v0, v4 if None is None else [*v4, None], v2)


def _parameter_70(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], v2, False, None is not None)


def _for_71(V, T):
    v0 = V[-10]
    v1 = V[-9]
    v3 = V[-7]
    v5 = V[-5]
    v7 = V[-3]
    del V[-9:]
    V[-1] = For(v0, Name(v1, T[v1]), v3, v5, None, v7)


def _and_72(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "And", v0, v2)


def _parameter_73(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Parameter(v0, T[v0], v4, False, v1 is not None)


def _sub_74(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v2 = V[-5]
    v4 = V[-3]
    del V[-6:]
    V[-1] = Sub(v0, T[v1], v2, v4)


def _variable_75(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = declare(v0, v2)


def _if_76(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = If(v0, v1, v4, v5)


def _none_77(V, T):
    V.pop()
    V[-1] = []


def _last_using_78(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = PrintItem(v0.at, v0, v2, "")


def _case_79(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Case(v0, v1, [])


def _user_type_80(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = UserType(v0, T[v1], v3)


def _input_81(V, T):
    v0 = V[-9]
    v2 = V[-7]
    v4 = V[-5]
    v6 = V[-3]
    v8 = V[-1]
    del V[-8:]
    V[-1] = Input(v0, v6, None if v4 is None else String(v4, string(T[v4])), v8 or [], v2)


def _startup_82(V, T):
    v0 = V[-5]
    v2 = V[-3]
    del V[-4:]
    V[-1] = Startup(v0, v2)


def _parameter_by_reference_83(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], v3, True, None is not None)


def _function_84(V, T):
    v0 = V[-7]
    v1 = V[-6]
    v2 = V[-5]
    v4 = V[-3]
    del V[-6:]
    V[-1] = Sub(v0, T[v1], v2, v4, True, None)


def _mod_85(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Mod", v0, v2)


def _input_86(V, T):
    v0 = V[-7]
    v2 = V[-5]
    v4 = V[-3]
    v6 = V[-1]
    del V[-6:]
    V[-1] = Input(v0, v4, None if None is None else String(None, string(T[None])), v6 or [], v2)


def _parameter_by_reference_87(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v2 = V[-2]
    del V[-3:]
    V[-1] = Parameter(v0, T[v1], None, True, v2 is not None)


def _print_using_two_88(V, T):
    v1 = V[-6]
    v3 = V[-4]
    v5 = V[-2]
    v6 = V[-1]
    del V[-6:]
    V[-1].append(PrintItem(v1.at, v1, [v3, v5], T[v6]))


def _pair_89(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = [v0, v2]


def _extend_90(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = extended(v0, v2)


def _repeat_91(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = Repeat(v0, v2, v4)


def _test_92(V, T):
    v0 = V[-1]
    V[-1] = CaseTest(v0.at, "=", v0)


def _while_93(V, T):
    v0 = V[-5]
    v1 = V[-4]
    v3 = V[-2]
    del V[-4:]
    V[-1] = While(v0, v1, v3)


def _third_94(V, T):
    v2 = V[-2]
    del V[-3:]
    V[-1] = v2


def _line_if_95(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = If(v0, v1, v3, [])


def _for_96(V, T):
    v0 = V[-9]
    v1 = V[-8]
    v3 = V[-6]
    v5 = V[-4]
    v7 = V[-2]
    del V[-8:]
    V[-1] = For(v0, Name(v1, T[v1]), v3, v5, None, v7)


def _for_97(V, T):
    v0 = V[-11]
    v1 = V[-10]
    v3 = V[-8]
    v5 = V[-6]
    v7 = V[-4]
    v9 = V[-2]
    del V[-10:]
    V[-1] = For(v0, Name(v1, T[v1]), v3, v5, v7, v9)


def _sized_type_98(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = TypeName(v0, T[v0], v2)


def _line_if_else_99(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = If(v0, v1, v3, v5)


def _type_100(V, T):
    v0 = V[-1]
    V[-1] = TypeName(v0, T[v0])


def _else_if_101(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = [If(v0, v1, v4, v5)]


def _or_102(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = Binary(v0.at, "Or", v0, v2)


def _task_103(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    del V[-5:]
    V[-1] = task(v0, T[v1], v3)


def _print_104(V, T):
    v0 = V[-6]
    v2 = V[-4]
    v4 = V[-2]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Print(v0, v4 if v5 is None else [*v4, v5], v2)


def _last_open_105(V, T):
    v0 = V[-4]
    v2 = V[-2]
    del V[-3:]
    V[-1] = PrintItem(v0.at, v0, [v2], ",")


def _test_is_106(V, T):
    v2 = V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = CaseTest(v0, T[v1], v2)


def _select_nothing_107(V, T):
    v0 = V[-6]
    v2 = V[-4]
    del V[-5:]
    V[-1] = Select(v0, v2, [])


def _function_108(V, T):
    v0 = V[-9]
    v1 = V[-8]
    v2 = V[-7]
    v4 = V[-5]
    v6 = V[-3]
    del V[-8:]
    V[-1] = Sub(v0, T[v1], v2, v6, True, v4)


def _parameter_109(V, T):
    V.pop()
    v1 = V.pop()
    v0 = V[-1]
    V[-1] = Parameter(v0, T[v0], None, False, v1 is not None)


def _valued_variable_110(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = declare(v0, None, v2)


def _typed_variable_111(V, T):
    v0 = V[-5]
    v2 = V[-3]
    v4 = V[-1]
    del V[-4:]
    V[-1] = declare(v0, v2, v4)


def _input_112(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Input(v0, v3, None if v1 is None else String(v1, string(T[v1])), v5 or [], None)


def _print_using_113(V, T):
    v1 = V[-4]
    v3 = V[-2]
    v4 = V[-1]
    del V[-4:]
    V[-1].append(PrintItem(v1.at, v1, [v3], T[v4]))


def _const_114(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v3 = V[-3]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Const(v0, T[v1], v3, v5)


def _test_range_115(V, T):
    v2 = V.pop()
    V.pop()
    v0 = V[-1]
    V[-1] = CaseTest(v0.at, "To", v0, v2)


def _define_116(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Define(v0, T[v1], v3)


def _parameter_by_value_117(V, T):
    v0 = V[-6]
    v1 = V[-5]
    v2 = V[-4]
    v5 = V[-1]
    del V[-5:]
    V[-1] = Parameter(v0, T[v1], v5, False, v2 is not None)


def _const_118(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Const(v0, T[v1], None, v3)


def _input_119(V, T):
    v0 = V[-4]
    v1 = V[-3]
    v3 = V[-1]
    del V[-3:]
    V[-1] = Input(v0, v1, None if None is None else String(None, string(T[None])), v3 or [], None)


TOKEN = '(?:[ \t]+)?((?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++|(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|`(?:[^`\\\\\n]|\\\\[^\n])`|(?:/|\\\\)|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

CONTINUED = '(?:[ \t]+|[\\\\_][ \t]*+(?:\'[^\n]*+)?\n)*((?:(?:\'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++|(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])|[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++|(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])|"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"|`(?:[^`\\\\\n]|\\\\[^\n])`|(?:/|\\\\)|<<|<=|<>|>=|>>|"[^\\n]*|[0-9][A-Za-z0-9_]*|.)'

LITERALS = {
    '!': 'COMPLEMENT',
    '#': 'HASH',
    '%': 'MOD',
    '&': 'AMPERSAND',
    '(': 'LPAR',
    ')': 'RPAR',
    '*': 'STAR',
    '+': 'PLUS',
    ',': 'COMMA',
    '-': 'MINUS',
    '.': 'DOT',
    ':': 'COLON',
    ';': 'SEMICOLON',
    '<': 'COMPARE',
    '<<': 'SHIFT',
    '<=': 'COMPARE',
    '<>': 'COMPARE',
    '=': 'EQUAL',
    '>': 'COMPARE',
    '>=': 'COMPARE',
    '>>': 'SHIFT',
    '?': 'QMARK',
    '[': 'LSQB',
    ']': 'RSQB',
    '^': 'CIRCUMFLEX',
    'and': 'AND',
    'as': 'AS',
    'auto': 'AUTO',
    'byref': 'BYREF',
    'byval': 'BYVAL',
    'case': 'CASE',
    'const': 'CONST',
    'define': 'DEFINE',
    'dim': 'DIM',
    'do': 'DO',
    'else': 'ELSE',
    'elseif': 'ELSEIF',
    'end': 'END',
    'endif': 'ENDIF',
    'endl': 'ENDL',
    'endloop': 'ENDLOOP',
    'endw': 'ENDW',
    'endwhile': 'ENDWHILE',
    'event': 'EVENT',
    'exit': 'EXIT',
    'for': 'FOR',
    'function': 'FUNCTION',
    'gosub': 'GOSUB',
    'goto': 'GOTO',
    'if': 'IF',
    'input': 'INPUT',
    'is': 'IS',
    'loop': 'LOOP',
    'mod': 'MOD',
    'next': 'NEXT',
    'not': 'NOT',
    'nv': 'NV',
    'or': 'OR',
    'pause': 'PAUSE',
    'print': 'PRINT',
    'repeat': 'REPEAT',
    'return': 'RETURN',
    'run': 'RUN',
    'select': 'SELECT',
    'startup': 'STARTUP',
    'step': 'STEP',
    'sub': 'SUB',
    'task': 'TASK',
    'then': 'THEN',
    'to': 'TO',
    'type': 'TYPE',
    'until': 'UNTIL',
    'using': 'USING',
    'wend': 'WEND',
    'while': 'WHILE',
    'xor': 'XOR',
    '|': 'VBAR',
    '~': 'COMPLEMENT',
}

CLASSES = {
    '_NL': "(?:(?:'[^\n]*+|(?::[ \t]*+)?(?:[Rr][Ee][Mm]\\b|REM(?=[A-Z][a-z]))[^\n]*+)?\n[ \t]*+)++",
    'NAME': '(?!(?:[Rr][Ee][Mm]\\b|REM[A-Z][a-z]))[A-Za-z_][A-Za-z0-9_]*+(?!\\.[0-9])',
    'DOTTED': '[A-Za-z_][A-Za-z0-9_]*+(?:\\.[0-9]++)++',
    'NUMBER': '(?:0[xX][0-9a-fA-F]++|0[bB][01]++|(?:[0-9]++\\.?[0-9]*+|\\.[0-9]++)(?:[eE][+-]?[0-9]++)?+)(?![A-Za-z0-9_])',
    'STRING': '"[^"\\\\\n]*+(?:\\\\[^\n][^"\\\\\n]*+)*+"',
    'CHARACTER': '`(?:[^`\\\\\n]|\\\\[^\n])`',
    'DIVIDE': '(?:/|\\\\)',
}

RULES = (
    (2, 'body', _label_before_0),
    (1, 'inline_statement', _end_1),
    (2, 'body', _skip_2),
    (0, 'body', _body_3),
    (6, 'declaration', _event_4),
    (1, 'target', None),
    (2, 'inline_statement', _pause_5),
    (1, 'print', None),
    (3, 'name{leading}', _name_empty_6),
    (1, 'leading', None),
    (3, 'name{NAME}', _name_empty_6),
    (1, 'print', None),
    (2, 'not{atom}', _not_7),
    (4, 'name{NAME}', _name_args_8),
    (3, 'print_list', _print_item_9),
    (1, 'leading', None),
    (1, 'leading', None),
    (2, 'unary{atom}', _minus_10),
    (1, 'inline_statement', _auto_11),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (1, 'leading', None),
    (5, 'select_head', _select_12),
    (1, 'leading', None),
    (1, 'ref{name{leading}}', None),
    (1, 'leading', None),
    (0, 'items', _none_13),
    (1, 'leading', None),
    (3, 'body', _more_14),
    (2, 'items', _label_before_0),
    (1, 'target', None),
    (1, 'start', _module_15),
    (3, 'items', _more_14),
    (1, 'inline_statement', _return_16),
    (1, 'expr', None),
    (1, 'bit_or{atom}', None),
    (1, 'compare{atom}', None),
    (1, 'operand', None),
    (1, 'not{operand}', None),
    (3, 'ref{name{NAME}}', _member_17),
    (3, 'ref{name{leading}}', _member_17),
    (1, 'ref{name{word}}', None),
    (1, 'leading', None),
    (1, 'variable', None),
    (1, 'word', None),
    (1, 'statement', None),
    (1, 'term{atom}', None),
    (1, 'and{atom}', None),
    (1, 'word', None),
    (1, 'unary{atom}', None),
    (1, 'operand', _character_18),
    (1, 'target', None),
    (1, 'call', None),
    (2, 'not{operand}', _not_7),
    (1, 'bit_and{atom}', None),
    (1, 'atom', None),
    (1, 'leading', None),
    (2, 'inline_statement', _bare_call_19),
    (3, 'select_head', _next_case_20),
    (1, 'term{operand}', None),
    (1, 'bare', _one_21),
    (3, 'ref{name{word}}', _member_17),
    (3, 'body', _more_14),
    (2, 'unary{operand}', _complement_22),
    (1, 'unary{operand}', None),
    (1, 'bit_and{operand}', None),
    (2, 'parameter', _parameter_by_value_23),
    (1, 'power{atom}', None),
    (1, 'inline_statement', _exit_24),
    (1, 'and{operand}', None),
    (2, 'inline_statement', _run_25),
    (1, 'power{operand}', None),
    (2, 'unary{operand}', _minus_10),
    (1, 'operand', _number_26),
    (1, 'or{operand}', None),
    (3, 'items', _more_14),
    (3, 'items', _more_14),
    (1, 'compare{operand}', None),
    (1, 'sep', None),
    (2, 'unary{operand}', _plus_27),
    (1, 'shift{operand}', None),
    (2, 'inline_statement', _label_28),
    (1, 'shift{atom}', None),
    (0, 'parameters', _none_13),
    (3, 'case', _case_else_29),
    (1, 'sum{atom}', None),
    (3, 'items', _more_14),
    (4, 'select', _last_case_30),
    (6, 'ref{name{NAME}}', _member_args_31),
    (1, 'sum{operand}', None),
    (3, 'inline_statement', _dim_32),
    (1, 'operand', _string_33),
    (2, 'inline_statement', _print_34),
    (1, 'variable', None),
    (3, 'inline_statement', _print_35),
    (2, 'inline_statement', _dim_36),
    (3, 'inline_statement', _gosub_37),
    (0, 'task_body', _body_3),
    (2, 'inline_statement', _input_38),
    (4, 'name{NAME}', _name_axes_39),
    (2, 'inline_statement', _goto_40),
    (1, 'or{atom}', None),
    (2, 'inline_statement', _exit_41),
    (1, 'bit_or{operand}', None),
    (1, 'not{atom}', None),
    (2, 'unary{atom}', _plus_27),
    (4, 'parameter', _parameter_by_value_42),
    (3, 'items', _more_14),
    (3, 'inline_statement', _goto_43),
    (1, 'dims', _plain_variable_44),
    (3, 'body', _more_14),
    (1, 'print_last', _last_item_45),
    (1, 'exit_kind', None),
    (1, 'name{word}', _name_46),
    (1, 'name{leading}', _name_46),
    (1, 'exit_kind', None),
    (1, 'sep', None),
    (1, 'seps', _none_47),
    (1, 'exit_kind', None),
    (4, 'parameter', _parameter_by_value_48),
    (1, 'exit_kind', None),
    (1, 'exit_kind', None),
    (2, 'items', _skip_2),
    (1, 'exit_kind', None),
    (1, 'ref{name{NAME}}', None),
    (1, 'call', None),
    (1, 'exit_kind', None),
    (1, 'exprs', _one_21),
    (1, 'exit_kind', None),
    (1, 'name{NAME}', _name_46),
    (2, 'inline_statement', _end_49),
    (1, 'inline_statement', None),
    (2, 'inline_statement', _gosub_50),
    (0, 'print_list', _none_13),
    (1, 'exit_kind', None),
    (1, 'dims', _one_21),
    (3, 'atom', _inner_51),
    (1, 'axes', _dotted_52),
    (1, 'inline_statement', _call_53),
    (0, 'members', _none_13),
    (2, 'unary{atom}', _complement_22),
    (1, 'declaration', None),
    (3, 'sum{atom}', _binary_54),
    (3, 'inline_statement', _assign_55),
    (6, 'parameter', _parameter_by_reference_56),
    (2, 'end_loop', _skip_2),
    (12, 'inline_statement', _for_57),
    (3, 'tests', _more_58),
    (3, 'bare', _more_58),
    (1, 'end_loop', None),
    (3, 'members', _extend_59),
    (1, 'end_loop', None),
    (3, 'or{atom}', _xor_60),
    (4, 'inline_statement', _input_61),
    (2, 'parameter', _parameter_by_reference_62),
    (1, 'parameter', _parameter_63),
    (7, 'inline_statement', _input_64),
    (3, 'exprs', _more_58),
    (4, 'inline_statement', _assign_65),
    (5, 'inline_statement', _input_66),
    (4, 'inline_statement', _loop_67),
    (3, 'parameters', _inner_51),
    (3, 'dims', _more_values_68),
    (5, 'inline_statement', _print_69),
    (3, 'parameter', _parameter_70),
    (10, 'inline_statement', _for_71),
    (3, 'and{atom}', _and_72),
    (5, 'parameter', _parameter_73),
    (2, 'seps', _skip_2),
    (7, 'routine', _sub_74),
    (3, 'compare{atom}', _binary_54),
    (2, 'end_if', _skip_2),
    (3, 'dim', _variable_75),
    (3, 'member', _variable_75),
    (6, 'statement', _if_76),
    (2, 'parameters', _none_77),
    (3, 'power{operand}', _binary_54),
    (3, 'print_last', _last_using_78),
    (1, 'line_tail', _one_21),
    (2, 'else_if', _skip_2),
    (3, 'case', _case_79),
    (1, 'formats', _one_21),
    (6, 'ref{name{word}}', _member_args_31),
    (6, 'declaration', _user_type_80),
    (3, 'name{word}', _name_empty_6),
    (9, 'inline_statement', _input_81),
    (3, 'term{operand}', _binary_54),
    (3, 'member_list', _more_58),
    (5, 'declaration', _startup_82),
    (4, 'parameter', _parameter_by_reference_83),
    (4, 'name{word}', _name_args_8),
    (7, 'inline_statement', _input_64),
    (7, 'routine', _function_84),
    (3, 'shift{operand}', _binary_54),
    (3, 'term{operand}', _mod_85),
    (3, 'power{atom}', _binary_54),
    (7, 'inline_statement', _input_86),
    (4, 'parameter', _parameter_by_reference_87),
    (7, 'print_list', _print_using_two_88),
    (3, 'formats', _pair_89),
    (4, 'members', _extend_90),
    (6, 'ref{name{leading}}', _member_args_31),
    (4, 'members', _extend_90),
    (1, 'closed', _one_21),
    (3, 'bit_or{atom}', _binary_54),
    (3, 'term{atom}', _binary_54),
    (5, 'inline_statement', _repeat_91),
    (3, 'term{atom}', _mod_85),
    (3, 'shift{atom}', _binary_54),
    (3, 'term{operand}', _binary_54),
    (1, 'end_while', None),
    (1, 'test', _test_92),
    (5, 'inline_statement', _while_93),
    (2, 'task_body', _label_before_0),
    (3, 'bit_and{atom}', _binary_54),
    (4, 'if_tail', _third_94),
    (2, 'task_body', _skip_2),
    (3, 'term{atom}', _binary_54),
    (3, 'sum{atom}', _binary_54),
    (3, 'compare{atom}', _binary_54),
    (4, 'inline_statement', _input_61),
    (1, 'end_while', None),
    (1, 'end_while', None),
    (4, 'line_if', _line_if_95),
    (1, 'member_list', _one_21),
    (7, 'print_list', _print_using_two_88),
    (1, 'parameter_list', _one_21),
    (9, 'inline_statement', _for_96),
    (11, 'inline_statement', _for_97),
    (3, 'inline', _more_58),
    (3, 'compare{operand}', _binary_54),
    (1, 'inline', _one_21),
    (3, 'type', _sized_type_98),
    (6, 'line_if', _line_if_else_99),
    (1, 'type', _type_100),
    (6, 'if_tail', _else_if_101),
    (3, 'dims', _more_58),
    (3, 'task_body', _more_14),
    (3, 'sum{operand}', _binary_54),
    (1, 'line_tail', None),
    (3, 'or{operand}', _xor_60),
    (1, 'tests', _one_21),
    (3, 'line_tail', _more_58),
    (3, 'closed', _more_58),
    (4, 'name{leading}', _name_args_8),
    (1, 'else_if', None),
    (3, 'bit_or{operand}', _binary_54),
    (1, 'if_tail', _none_47),
    (1, 'end_if', None),
    (3, 'compare{operand}', _binary_54),
    (3, 'and{operand}', _and_72),
    (3, 'or{operand}', _or_102),
    (6, 'if_tail', _else_if_101),
    (9, 'inline_statement', _input_81),
    (3, 'or{atom}', _or_102),
    (3, 'task_body', _more_14),
    (3, 'members', _extend_59),
    (3, 'bit_and{operand}', _binary_54),
    (6, 'declaration', _task_103),
    (3, 'parameter_list', _more_58),
    (6, 'inline_statement', _print_104),
    (3, 'task_body', _more_14),
    (6, 'closed_if', _line_if_else_99),
    (4, 'print_last', _last_open_105),
    (4, 'name{leading}', _name_axes_39),
    (3, 'test', _test_is_106),
    (3, 'sum{operand}', _binary_54),
    (6, 'statement', _if_76),
    (3, 'task_body', _more_14),
    (1, 'closed', None),
    (3, 'task_body', _more_14),
    (6, 'select', _select_nothing_107),
    (9, 'routine', _function_108),
    (3, 'parameter', _parameter_109),
    (2, 'end_while', _skip_2),
    (3, 'dim', _valued_variable_110),
    (5, 'dim', _typed_variable_111),
    (6, 'inline_statement', _input_112),
    (5, 'print_list', _print_using_113),
    (3, 'test', _test_is_106),
    (6, 'inline_statement', _input_112),
    (6, 'inline_statement', _const_114),
    (3, 'test', _test_range_115),
    (4, 'inline_statement', _define_116),
    (4, 'name{word}', _name_axes_39),
    (6, 'parameter', _parameter_by_value_117),
    (4, 'inline_statement', _const_118),
    (3, 'print_list', _print_item_9),
    (4, 'inline_statement', _input_119),
)

ROWS = (
    'd0',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 513=formats 531=expr',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 326=UNTIL',
    '164=SELECT 250=NAME d1',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 505=expr',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 358=IS 410=expr 457=test 482=ELSE 516=tests',
    '155=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 405=atom,axes,operand,power{atom},unary{atom},variable',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 351=atom,axes,operand,unary{atom},variable',
    'd2',
    '254=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '327=body d3',
    '77=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd4',
    '149=DOT d5',
    '446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 525=type',
    'd6',
    '193=COMMA 486=RSQB',
    '344=type 446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED 367=exprs',
    '71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 307=and{atom},not{atom}',
    '270=RPAR',
    'd7',
    'd8',
    '193=COMMA 462=RPAR',
    '173=name{word},ref{name{word}} 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 425=axes,variable',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 483=expr',
    '185=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d9',
    'd10',
    '177=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '183=RSQB 193=COMMA',
    'd11',
    '160=CASE',
    'd12',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 403=atom,axes,operand,power{atom},unary{atom},variable',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 421=atom,axes,operand,power{atom},unary{atom},variable',
    'd13',
    '195=COLON,_NL,sep',
    'd14',
    '238=COLON,_NL,sep',
    'd15',
    '232=COLON,_NL,sep d16',
    '184=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 285=HASH',
    'd17',
    'r18=COLON,ELSE,_NL d19',
    'd20',
    'd21',
    'd22',
    'd23',
    'd24',
    '280=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d25',
    'd26',
    'd27',
    '36=RPAR 193=COMMA',
    '62=items 106=start d28',
    '125=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d29',
    'd30',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED 445=exprs',
    'd31',
    '213=body d3',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 366=formats 531=expr',
    '12=DOT d32',
    '6=FUNCTION 10=DEFINE 14=ref{name{NAME}} 27=EVENT 29=SUB 32=SELECT 39=LOOP 41=STARTUP 42=GOTO 44=AUTO 50=TYPE 55=RUN 58=_NL 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,NV,STEP,TO,USING,leading 228=END 233=INPUT 242=COLON 244=name{NAME} 249=NAME 257=TASK 260=PRINT,QMARK,print 262=WHILE 267=CONST 268=declaration,routine 271=DOTTED 272=inline_statement,select,statement 276=call 279=REPEAT 284=GOSUB 286=line_if d33',
    '315=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 316=BYREF 330=parameter_list 348=RPAR 433=parameter 495=BYVAL',
    '23=RPAR 24=exprs 70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED',
    '16=expr 70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    'd34',
    '335=type 446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd35',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED 392=exprs',
    '20=XOR 266=OR d36',
    '171=AMPERSAND d37',
    '166=SHIFT d38',
    'd39',
    '43=atom,axes,operand,unary{atom},variable 74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    '226=VBAR d40',
    '69=LPAR d41',
    '219=LPAR d42',
    'd43',
    'd44',
    'd19',
    '180=EQUAL',
    'd45',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 197=atom,axes,operand,unary{atom},variable 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 526=expr',
    'd46',
    '292=type 446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd25',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 302=ENDLOOP 306=ENDL 308=END 325=end_loop',
    'd47',
    '259=CIRCUMFLEX d48',
    'd49',
    'd50',
    'd51',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 452=term{atom}',
    'd52',
    'r53=EQUAL d54',
    '28=RPAR 53=exprs 70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED',
    'd55',
    '300=body d3',
    '103=EQUAL 162=COMPARE d56',
    'd29',
    'd57',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 423=shift{atom}',
    '147=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd58',
    '',
    '163=COMMA d59',
    'd60',
    '8=CIRCUMFLEX d61',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 488=term{atom}',
    '263=OR 281=XOR d62',
    '57=LPAR d63',
    'd64',
    'd65',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 531=expr 532=formats',
    '10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 233=INPUT 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 354=line_if 375=IF 399=closed_if 429=line_tail 440=inline_statement,select 491=inline 530=closed',
    'd66',
    '200=EQUAL 236=COMPARE d67',
    '508=AS 514=LPAR d68',
    'd69',
    '187=EVENT,FOR,FUNCTION,LOOP,REPEAT,SELECT,SUB,TASK,WHILE,exit_kind d70',
    '71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 98=not{atom} 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    '178=dims 209=name{word} 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 224=NV 269=dim',
    'd71',
    'd72',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 422=term{atom}',
    'd73',
    '173=name{word},ref{name{word}} 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 317=axes,variable',
    '15=AS 84=EQUAL',
    'd74',
    'd75',
    '273=AND d76',
    'd77',
    'd78',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 144=atom,axes,operand,unary{atom},variable 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    '315=AUTO,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 316=BYREF 479=parameter 495=BYVAL',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 218=expr 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 510=expr',
    '10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 233=INPUT 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 354=line_if 375=IF 399=closed_if 429=line_tail 440=inline_statement,select 442=_NL 491=inline 493=closed',
    '222=SHIFT d79',
    'd80',
    'd16',
    '2=body d3',
    'd81',
    '94=PLUS 110=MINUS d82',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 518=expr',
    'd83',
    '396=COLON,_NL,sep',
    '76=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '30=exprs 70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED',
    '216=COLON,_NL,sep 251=AS',
    '126=PLUS 274=MINUS d84',
    'd9',
    '74=MINUS 83=PLUS 95=CHARACTER 114=atom,axes,operand,unary{atom},variable 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    '63=LPAR 151=parameters d85',
    '33=not{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    '74=MINUS 83=PLUS 95=CHARACTER 130=atom,axes,operand,unary{atom},variable 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    'd86',
    '7=MOD 34=STAR 35=DIVIDE d87',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 295=expr',
    'd88',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 342=shift{atom}',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 301=expr',
    'd89',
    'd90',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 406=sum{atom}',
    '205=DIVIDE 275=STAR 277=MOD d91',
    '258=COMMA d92',
    'd93',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 176=print_last 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 215=expr 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED d94',
    '72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 414=compare{atom}',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 298=test 358=IS 410=expr',
    '287=DOT d95',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 417=END',
    '138=EQUAL',
    'd96',
    '63=LPAR 148=parameters d85',
    '258=COMMA d97',
    'd98',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED 291=exprs',
    '501=task_body d99',
    '115=USING d100',
    'd101',
    'd102',
    '99=COLON,_NL,sep',
    '217=AND d103',
    'd104',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 283=atom,axes,operand,unary{atom},variable',
    '37=DO 139=THEN',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED 363=exprs 365=RPAR',
    '173=name{word},ref{name{word}} 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 311=axes,variable',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 241=expr 271=DOTTED',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 318=expr',
    '282=AMPERSAND d105',
    '320=body d3',
    '240=VBAR d106',
    'd107',
    '21=expr 70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    '499=body d3',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 438=shift{atom}',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 441=atom,axes,operand,unary{atom},variable',
    'd108',
    'd109',
    'd110',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 368=atom,axes,operand,power{atom},unary{atom},variable',
    '17=exprs 70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED',
    '25=SEMICOLON 191=COMMA',
    '502=RPAR',
    '4=EQUAL 18=AS d111',
    '175=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 189=expr 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED',
    'd112',
    '0=_NL 3=END 5=CASE 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 108=case 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB',
    '498=SELECT',
    '38=SEMICOLON 519=USING 529=COMMA d113',
    '304=body d3',
    '71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 338=not{atom}',
    '356=COMMA',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 246=expr 271=DOTTED 435=exprs',
    'd114',
    '19=LSQB 190=LPAR d115',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 379=sum{atom}',
    '64=LPAR 206=LSQB d116',
    '168=dims 209=name{word} 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 269=dim d21',
    'd117',
    '72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 464=bit_and{atom}',
    'd118',
    '250=NAME d1',
    'd119',
    'd120',
    '56=COLON 212=_NL',
    '174=body d3',
    '173=name{word},ref{name{word}} 182=axes,variable 192=HASH 207=STRING 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED d27',
    '314=AS d121',
    '113=_NL',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 467=shift{atom}',
    'd122',
    '88=body d3',
    'd123',
    '72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 401=bit_and{atom}',
    '460=COMMA',
    'd124',
    'd125',
    'r126=DOT,EQUAL d127',
    'd128',
    'd129',
    'd130',
    '179=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '75=bit_or{operand} 95=CHARACTER 97=LPAR 107=bare 109=axes,operand,power{operand},unary{operand},variable 111=or{operand} 118=compare{operand} 122=NOT 131=NUMBER 132=and{operand},not{operand} 135=PLUS 140=shift{operand} 145=sum{operand} 150=LSQB 154=COMPLEMENT 157=MINUS 167=term{operand} 169=STRING 173=name{word},ref{name{word}} 194=bit_and{operand} 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED d131',
    'd132',
    '446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 459=type',
    'd133',
    '199=COLON,_NL,sep',
    '146=EQUAL',
    '5=CASE 49=case 214=END 340=COLON,_NL,sep',
    'd134',
    '261=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d58',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 333=shift{atom} 427=name{word} 448=dim',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 384=atom,axes,operand,unary{atom},variable',
    '137=HASH 170=print_list d135',
    '181=COLON,_NL,sep',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 253=expr 271=DOTTED',
    '71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 470=and{atom},not{atom}',
    '497=COLON,_NL,sep',
    'd136',
    '71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 474=and{atom},not{atom}',
    '129=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '66=_NL 203=COLON',
    'd137',
    'd138',
    'd139',
    '133=_NL 161=COLON',
    '71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 468=not{atom}',
    '74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 290=term{atom}',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 408=atom,axes,operand,power{atom},unary{atom},variable',
    'd140',
    '74=MINUS 83=PLUS 95=CHARACTER 131=NUMBER 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 383=atom,axes,operand,power{atom},unary{atom},variable',
    '340=COLON,_NL,sep 397=members d141',
    '143=COLON,_NL,sep',
    '229=COLON,_NL,sep 278=seps',
    '71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 454=and{atom},not{atom}',
    '72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 131=NUMBER 152=sum{atom} 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 188=COMPLEMENT 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 477=compare{atom}',
    'd142',
    '248=HASH 256=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '204=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '134=_NL',
    '112=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd143',
    '173=name{word},ref{name{word}} 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 377=axes,variable',
    '7=MOD 34=STAR 35=DIVIDE d144',
    '193=COMMA 321=SEMICOLON d145',
    'd146',
    'd147',
    'd148',
    '229=COLON,_NL,sep 255=seps',
    '10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 233=INPUT 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 375=IF 437=inline_statement,select 458=line_if 461=closed_if',
    '329=body d3',
    'd149',
    '116=THEN',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 382=END',
    'd150',
    'd151',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 522=END',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 509=END',
    'd152',
    'd153',
    '217=AND d154',
    '250=NAME 293=LOOP d1',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 507=formats 531=expr',
    '346=type 446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '309=USING d155',
    '492=AS 494=LPAR d156',
    '250=NAME 341=SUB d1',
    '446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 521=type',
    '67=AS 208=LPAR d157',
    '312=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d20',
    '337=USING d158',
    'd159',
    '10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 233=INPUT 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 437=inline_statement,select 455=IF 458=line_if',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 347=if_tail 450=ELSE 451=ELSEIF,else_if 465=end_if 466=ENDIF 469=END',
    'd160',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 439=expr',
    '371=USING d161',
    '345=THEN',
    'd162',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 404=expr',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 450=ELSE 451=ELSEIF,else_if 465=end_if 466=ENDIF 469=END 471=if_tail',
    '303=body d3',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 434=NEXT',
    '136=COMMA 332=RPAR',
    '10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 233=INPUT 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 354=line_if 375=IF 399=closed_if 440=inline_statement,select 444=line_tail 484=closed 491=inline',
    'd163',
    '166=SHIFT d164',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 215=expr 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 480=print_last d165',
    'd166',
    'd167',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 472=formats 531=expr',
    'd168',
    'd169',
    'd170',
    'd171',
    '166=SHIFT d172',
    'd173',
    '380=EQUAL d174',
    '10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 233=INPUT 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 354=line_if 375=IF 399=closed_if 429=line_tail 440=inline_statement,select 491=inline 493=closed',
    'd175',
    'd176',
    'd177',
    '10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 233=INPUT 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 354=line_if 440=inline_statement,select 444=line_tail 453=inline 455=IF',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 416=expr',
    'd178',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 419=end_if 466=ENDIF 469=END',
    'd179',
    'd180',
    'd181',
    '334=print_list d135',
    'd182',
    '360=EQUAL 528=COMPARE',
    '485=COMMA 511=SEMICOLON d183',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 512=expr',
    'd184',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 313=END',
    '193=COMMA 376=RPAR',
    'd185',
    'd186',
    'd187',
    '193=COMMA 520=RSQB',
    '259=CIRCUMFLEX d188',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 517=expr',
    'd189',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 385=formats 531=expr',
    'd190',
    'd191',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 228=END 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 436=NEXT',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 299=expr',
    'd192',
    '60=USING d193',
    'd194',
    '126=PLUS 274=MINUS d195',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 506=expr',
    '221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 424=name{word} 430=member 504=member_list',
    '13=EVENT 250=NAME d1',
    '259=CIRCUMFLEX d196',
    'd197',
    'd198',
    '86=AS d199',
    'd200',
    '352=body d3',
    '387=COMMA 432=SEMICOLON d201',
    'd202',
    'd203',
    '165=RPAR 193=COMMA',
    'd204',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 447=if_tail 450=ELSE 451=ELSEIF,else_if 465=end_if 466=ENDIF 469=END',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 450=ELSE 451=ELSEIF,else_if 465=end_if 466=ENDIF 469=END 489=if_tail',
    '362=body d3',
    '221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 381=DIM 398=END 400=member_list 424=name{word} 430=member',
    '364=TYPE',
    'd205',
    '305=COLON 473=COMMA 476=_NL',
    '171=AMPERSAND d206',
    '449=_NL 496=COLON',
    '259=CIRCUMFLEX d207',
    'd208',
    '259=CIRCUMFLEX d209',
    '126=PLUS 274=MINUS d210',
    '250=NAME 478=TASK d1',
    '259=CIRCUMFLEX d211',
    'd212',
    '369=TO d213',
    '475=_NL',
    'd214',
    'd215',
    '103=EQUAL 162=COMPARE d216',
    '481=_NL 490=COLON',
    '456=COLON,_NL,sep',
    '250=NAME 372=STARTUP d1',
    '250=NAME 503=WHILE d1',
    'd217',
    'd218',
    '259=CIRCUMFLEX d219',
    '7=MOD 34=STAR 35=DIVIDE d220',
    '166=SHIFT d221',
    '310=AS',
    '1=USING d222',
    'd223',
    '4=EQUAL 18=AS d43',
    'd224',
    'd225',
    'd226',
    '339=type 446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    'd227',
    'd228',
    '336=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d229',
    '193=COMMA 391=RPAR',
    '294=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d230',
    'd231',
    '166=SHIFT d232',
    '297=COLON,_NL,sep 350=STEP',
    'd233',
    'd234',
    '395=body d3',
    '11=COLON,_NL,sep',
    'd235',
    '193=COMMA 361=RPAR',
    '201=STAR d236',
    'd237',
    'd238',
    'd239',
    '355=IF 388=COLON,_NL,sep',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 527=expr',
    '7=MOD 34=STAR 35=DIVIDE d240',
    '319=COLON d241',
    '217=AND d242',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 324=expr',
    '374=body d3',
    'd243',
    'd244',
    '328=COLON,_NL,sep',
    '173=name{word},ref{name{word}} 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 323=axes,variable 524=STRING',
    'd245',
    'd246',
    'd247',
    '171=AMPERSAND d248',
    'd249',
    'd250',
    '166=SHIFT d251',
    'd252',
    '250=NAME 343=IF d1',
    '217=AND d253',
    'd254',
    'd255',
    '221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 370=member 424=name{word}',
    '217=AND d256',
    'd257',
    'd258',
    '103=EQUAL 162=COMPARE d259',
    'd260',
    'd261',
    'd262',
    'd263',
    '158=COLON,_NL,sep',
    'd201',
    'd264',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 389=expr d265',
    'd266',
    'd267',
    '7=MOD 34=STAR 35=DIVIDE d268',
    'd269',
    'd270',
    '296=COLON r241=_NL d271',
    '373=type 446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '349=ELSE',
    '386=RPAR',
    '119=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word d44',
    'd272',
    '394=body d3',
    'd273',
    '0=_NL 9=COLON 10=DEFINE 14=ref{name{NAME}} 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 231=inline_statement,select,statement 233=INPUT 235=line_if 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 409=ENDW 412=end_while 418=END 426=WEND 428=ENDWHILE',
    'd274',
    '6=FUNCTION 10=DEFINE 14=ref{name{NAME}} 29=SUB 32=SELECT 39=LOOP 42=GOTO 44=AUTO 55=RUN 59=select_head 61=name{leading},ref{name{leading}} 65=PAUSE 68=RETURN 81=target 96=axes 104=HASH 121=EXIT 123=DIM 210=FOR 211=IF 223=BYREF,BYVAL,EVENT,NV,STARTUP,STEP,TASK,TO,TYPE,USING,leading 233=INPUT 244=name{NAME} 249=NAME 260=PRINT,QMARK,print 262=WHILE 267=CONST 271=DOTTED 276=call 279=REPEAT 284=GOSUB 402=routine 407=END 411=line_if 413=_NL 415=inline_statement,select,statement 420=COLON',
    '431=AS d275',
    'd276',
    '390=_NL 393=COLON 473=COMMA',
    'd277',
    'd278',
    'd279',
    '202=type 446=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word',
    '250=NAME 378=FUNCTION d1',
    '322=TO',
    'd280',
    'd281',
    'd282',
    '234=RPAR',
    'd283',
    '172=COMMA 357=COLON,_NL,sep',
    'd284',
    'd285',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 353=formats 359=expr',
    'd286',
    'd287',
    '250=NAME 500=FUNCTION d1',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 515=expr',
    '128=COMMA 289=SEMICOLON',
    '523=EQUAL',
    'd288',
    '264=THEN 443=DO',
    '70=or{atom} 71=bit_and{atom} 72=shift{atom} 74=MINUS 83=PLUS 90=atom,axes,operand,power{atom},unary{atom},variable 95=CHARACTER 100=compare{atom} 131=NUMBER 152=sum{atom} 156=NOT 159=term{atom} 169=STRING 173=name{word},ref{name{word}} 186=and{atom},not{atom} 188=COMPLEMENT 196=bit_or{atom} 198=LPAR 221=AUTO,BYREF,BYVAL,EVENT,INPUT,NAME,NV,RUN,STARTUP,STEP,TASK,TO,TYPE,USING,leading,word 271=DOTTED 487=expr',
    'd289',
    '331=ELSE',
    '26=COMMA d183',
    'd290',
)

TABLES = Tables(TOKEN, CONTINUED, LITERALS, CLASSES, RULES, ROWS, 54, 106)
