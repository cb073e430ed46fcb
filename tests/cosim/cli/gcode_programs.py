"""Small G-code programs, one for each feature, and random ones."""

import random

# The modes in which programs begin, because rs274 begins with G99.
START = "G17 G21 G40 G49 G54 G64 G80 G90 G91.1 G94 G98\n"

GOOD = {
    "rapid": "G0 X1 Y2 Z3\nX4\nG0 A10 B20 C30\n",
    "feed": "G1 F100\nX1\nY2 F200\nG0 Z5\nG1 Z0\n",
    "blanks in numbers": "g0 x+0. 12 34 y 7\nG 1 X -.5 F 1 0 0\n",
    "inches": "G20\nG1 X1 F10\nG21\nX50.8\nG20 G2 X3 I0.5\nG91 G1 Y1\nG21 Y1\n",
    "inches and offsets": "G20 G10 L2 P1 X1\nG92 Y2\nG0 X0 Y0\nG21 X25.4\nG43.1 Z10\nG20 G0 Z1\n",
    "planes": "G17 G2 X10 I5 F100\nG18 G3 X0 Z0 R20\nG19 G2 Y10 J5\nG18 G2 X5 Z5 I2.5 K2.5\nG19 G3 Z9 Y1 R8\n",
    "arcs by radius": "G2 X5 R-5 F10\nG3 X0 R5\nG2 X5 R2.5\nG3 X10 Y5 R5 P2\nG2 X5.0 Y0 R7.0711\n",
    "arcs by centre": "G2 X10 I5 F10\nG3 X0 Y10 I-10\nG2 I5\nG3 J-3\nG2 X1 Y11 J1\n",
    "absolute centres": "G90.1 G2 X10 I5 J0 F10\nG3 X20 I15 J0\nG91 G2 X-10 I15 J0\n",
    "helices": "G2 X10 I5 Z5 F10\nG3 I2 Z0 P3\nG18 G2 X12 I1 Y7 P2\nG17 G3 X0 Y0 R20 Z4 A90 B10 C5\n",
    "arc tolerance": "G2 X10 Y0.02 I5 F100\nG2 X2000 Y1 I995\n",
    "dwell": "G4 P1.5\nG4 P0\nG1 X1 F5 G4 P2\n",
    "incremental": "G91 G0 X1 Y1\nX1\nG1 Z-1 F10\nG2 X2 I1\nG90 G0 X0\n",
    "machine coordinates": "G10 L2 P1 X5 Y6 Z7\nG53 G0 X1\nG53 G1 Y2 Z3 F10\nG0 X0\n",
    "machine coordinates turned": "G10 L2 P1 X5 R90\nG53 G0 X1 Y2\nG0 X0 Y0\n",
    "coordinate systems": "".join(
        f"G10 L2 P{i + 1} X{i} Y{2 * i} Z{-i} A{i} R{3 * i}\nG{g}\nG0 X1 Y1 Z1\n"
        for i, g in enumerate(["54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3"])
    ),
    "same system again": "G10 L2 P2 X3\nG55\nG55\nG54\nG54 G0 X1\n",
    "origin from place": "G0 X1 Y2 Z3\nG10 L20 P1 X0\nG0 X0\nG10 L20 P0 Y5 Z5 A3\nG0 Y0 Z0\nG10 L20 P3 X9\nG56 G0 X0\n",
    "origin from place turned": "G10 L2 P1 R30\nG0 X10 Y5\nG10 L20 P1 X0 Y1\nG0 X3 Y3\n",
    "g92": "G0 X5 Y5\nG92 X0 Y1 Z2 A3\nG0 X1\nG92.2\nX1\nG92.3\nX1\nG92.1\nX1 Y1\n",
    "g92 turned": "G10 L2 P1 X1 Y2 R45\nG0 X1 Y1\nG92 X0 Y0 A5\nG0 X1 Y0\n",
    "g52": "G52 X5 Y6\nG0 X1 Y1\nG52 X0\nG0 X1\nG92 X0\nG52 Z1\nG0 Z0\n",
    "home": "G0 X5 Y6 Z7\nG28.1\nG0 X1 Y1\nG28 X2\nG0 X3 Y3\nG28\nG30.1\nG0 X0\nG30 Z3\nG91 G28 Z1\nG90\nG30\n",
    "home with offsets": "G0 X5 Y6 Z7\nG28.1\nG10 L2 P1 X1 Y1 Z1\nG92 X3\nG28 Y2\nG28\nG0 X0 Y0 Z0\n",
    "tool length": "G43.1 Z5\nG0 Z0\nG43.1 X1 Z2\nG0 X0 Z0\nG49\nG0 X0 Z0\n",
    "tool table": "G10 L1 P1 Z7\nT1 M6\nG43\nG0 Z3\nG10 L1 P2 X1 Z2\nG43 H2\nG0 X1 Z3\nG49\nG0 Z1\n",
    "tool change": "T1\nM6\nM3 S100\nT2 M6\nT0 M6\n",
    "path control": "G61\nG61.1\nG64\nG64 P0.1\nG64 P0.1 Q0.02\nG20 G64 P0.01\nG61 G0 X1\n",
    "inverse time": "G93 G1 X10 F2\nG2 X20 I5 F3\nG0 X0\nG1 A30 F2\nG1 X1 A5 F1\nG94 F100\nG1 X1\n",
    "inverse time helix": "G93 G3 I5 Z10 P2 F1\nG1 X0 Y0 Z0 F0.5\nG2 X3 Y3 I3 F2\nG20 G1 X1 F2\nG94 F3 X0\n",
    "feed modes": "F50 G94\nG93\nG93\nG94 F10\nG94 F20\nG1 X1\n",
    "spindle": "M3 S100\nM4\nS200.5 M5\nM3 M8 S1\nM7\nM9\n",
    "spindle at the end": "M3 S100\nM8\nM7\nM49\n",
    "overrides": "M48\nM49\nM50\nM50 P0\nM51\nM51 P0\nM52\nM52 P0\nM53\nM53 P0\n",
    "stops": "M0\nM1\nM60\nG0 X1 M0\n",
    "outputs": "M62 P1\nM63 P2\nM64 P3\nM65 P4\nM67 E0 Q5\nM68 E1 Q-1.5\nM62 P5 G1 X1 F10\nM66 P1 L0\nM66 E1 L0\n",
    "order of one line": "M62 P1 M3 S100 M8 F20 G18 G20 G1 X1 G55 G61 G91 G99 T1\n",
    "drill": "G0 Z10\nG81 X1 Y1 Z-1 R2 F100\nX2\nG99 X3\nX4\nG98 X5\nG80\nG0 X0\n",
    "drill from below": "G81 X1 Y1 Z-1 R2 F100\nX2\nG99 X3\n",
    "drill repeats": "G0 Z10\nG91 G81 X1 Y1 Z-3 R-5 L3 F100\nX1\nG99 X2 L2\nG80\n",
    "drill repeats at one place": "G81 X1 Z-1 R2 L3 F10\n",
    "drill and dwell": "G0 Z3\nG82 X1 Z-1 R2 P0.5 F10\nX2\nX3 P1\n",
    "drill in pecks": "G0 Z3\nG83 X1 Z-3 R2 Q2 F10\nX2\nX3 Q1.5 Z-2\nG98 Y2\n",
    "drill in pecks in inches": "G20 G0 Z1\nG83 X1 Z-1 Q0.5 R0.1 F10\nY1\n",
    "drill in other planes": "G18 G0 Y5\nG81 X1 Z2 Y-1 R2 F100\nX3\nG80 G19\nG0 X9\nG82 X-3 R1 Y2 Z3 P0.5\nZ4\n",
    "drill with exact stop": "G61.1\nG81 X1 Z-1 R2 F10\nG61\nX2\n",
    "drill with other control": "G64 P0.5\nG81 X1 Z-1 R2 F10\n",
    "expressions": "#1=[1+2*3**2 MOD 4]\nG0 X#1\nG0 X[2**3**2] Y[-7 MOD 3] Z-[2]\nX[2-3-4] Y[7 MOD -3] Z[10/4/5]\n",
    "comparisons": "X[1 EQ 1.00001] Y[1 NE 2] Z[1 GT 2] G0\nX[2 GE 2] Y[1 LT 0] Z[3 LE 3]\n",
    "logic": "G0 X[1 AND 0] Y[1 OR 0] Z[1 XOR 1]\nX[1 LT 2 AND 3 GT 4 OR 1]\nX[0 OR 1 AND 0]\n",
    "functions": "G0 X[ABS[-3]] Y[ACOS[0.5]] Z[ASIN[0.5]]\nX[ATAN[1]/[-1]] Y[COS[60]] Z[EXP[1.5]]\n"
    "X[FIX[-1.5]] Y[FUP[-1.5]] Z[LN[10]]\nX[ROUND[2.5]] Y[ROUND[-2.5]] Z[SIN[30]]\nX[SQRT[2]] Y[TAN[45]]\n",
    "powers": "G0 X[2**0.5] Y[10**-3] Z[1.5**7]\nX[-2**2] Y[0.1**0] Z[7**1.25]\n",
    "signs": "G0 X-[1+2] Y-SIN[90] Z+[3]\n#1=4\nX-#1 Y+#1\n",
    "parameters": "#1=2\nG0 X#1\n##1=5\nX#2\n#[1+2]=7 #4=#1\nX#3 Y#4\n#31=1\nX#31\n",
    "assignment after the line": "#1=1\n#1=2 G0 X#1\nX#1\n#5=1 #5=2\nX#5\n",
    "named parameters": "#<a>=5\n#<_glob>=6\nG0 X#<a> Y#<_glob>\n#< A b >=3\nX#<ab>\n#<x1>=[#<a>+EXISTS[#<nope>]+EXISTS[#<a>]]\nX#<x1>\n",
    "place parameters": "G0 X3 Y4 Z5\nG0 X[#5420+1] Y#5422\nG92 X0\nX[#5420+#<_y>]\n",
    "mode parameters": "G0 X#<_metric> Y#<_absolute>\nX#<_plane> Y#<_motion_mode> Z#<_coord_system>\nG91 G55 G18\nG90\n"
    "X#<_plane> Y#<_incremental> Z#<_coord_system>\nF12 S34\nX#<_feed> Y#<_rpm>\nG59.2\nX#<_coord_system>\n",
    "subroutine": "o100 sub\nG0 X#1 Y#2\n#1=9\no100 endsub\no100 call [1] [2]\no100 call [3]\nG0 Z#1\n",
    "named subroutine": "o<My Sub> sub\nG0 X[#1*2]\no<my sub> endsub\no<mysub> call [SQRT[16]]\n",
    "return": "o1 sub\no2 if [#1 GT 0]\no1 return [#1+1]\no2 endif\nG0 Z1\no1 endsub [7]\no1 call [5]\n"
    "G0 X#<_value> Y#<_value_returned>\no1 call [-1]\nG0 X#<_value>\n",
    "recursion": "o1 sub\no2 if [#1 GT 0]\nG0 X#1\no1 call [#1-1]\nG0 Y#1\no2 endif\no1 endsub\no1 call [5]\n",
    "local names": "o1 sub\n#<n>=#1\nG0 X#<n>\no1 endsub\n#<n>=4\no1 call [2]\nG0 Y#<n>\n",
    "if": "#1=2\no1 if [#1 EQ 1]\nG0 X1\no1 elseif [#1 EQ 2]\nG0 X2\no1 elseif [#1 EQ 2]\nG0 X3\no1 else\nG0 X4\no1 endif\n"
    "o2 if [0]\nG0 Y1\no2 else\nG0 Y2\no2 endif\no3 if [1]\nG0 Z1\no3 else\nG0 Z2\no3 endif\n",
    "while": "o1 while [#1 LT 5]\n#1=[#1+1]\no2 if [#1 EQ 2]\no1 continue\no2 endif\no3 if [#1 EQ 4]\no1 break\no3 endif\n"
    "G0 X#1\no1 endwhile\nG0 Y#1\n",
    "do": "o1 do\n#1=[#1+1]\nG0 X#1\no1 while [#1 LT 3]\no2 do\n#1=[#1-1]\no3 if [#1 LT 1]\no2 break\no3 endif\nG0 Y#1\no2 while [1]\n",
    "repeat": "o1 repeat [3]\n#1=[#1+1]\nG0 X#1\no1 endrepeat\no2 repeat [0]\nG0 X9\no2 endrepeat\n",
    "nested loops": "o1 repeat [2]\n#2=0\no2 while [#2 LT 3]\n#2=[#2+1]\no3 repeat [2]\nG0 X#2\no3 endrepeat\no2 endwhile\no1 endrepeat\n",
    "comments": "(hello)\nG0 X1 (a) Y1 (b)\n(MSG, hi)\n(debug,v #1 #<_metric>)\n; no comment\nG0 X2 ; nor this\n",
    "messages": "#1=2.5\n#<ab>=-3\n(DEBUG, #1 and #< AB >, #9, #<nope>)\n(msg,#1)\n",
    "line numbers": "N10 G0 X1\nN20.5 X2\nn 3 0 x3\n",
    "block delete off": "/G0 X5\n/ G0 X6\n",
    "lower case and blanks": "g0x1\n\tg1 y2 f1 0\n\n  \n",
    "rotation": "G10 L2 P1 R30\nG0 X10\nG1 Y5 F10\nG2 X20 Y5 I5\nG18 G2 X30 I5\nG10 L2 P1 R0\nG0 X0\n",
    "cutter off": "G40\nG0 X1\n",
    "g80": "G0 X1\nG80\nG0 X2\nG1 X3 F10\nG80\n",
    "polar places": "G0 @5 ^30\n@10 ^45\nG91 @5\n^15\nG90 G1 @5 F10\n@6 Z2\nG0 X3 Y4\n@10\n^-90\nG91 @1 ^10 G1\nG90 G0 ^370\n",
    "polar places with offsets": "G0 X3 Y4\nG10 L2 P2 X1 Y1 R20 G55\n@10\nG20 @1 ^0\n@2\nG92 X1\n^45\nG2 @2 ^90 R2 F5\n",
    "surface speed": "G96 D2500 S250\nM3\nG97 S300\nG96 S20\nG0 X#<_spindle_css_mode> Y#<_spindle_rpm_mode>\nG97\nM5\nG96 S1\n",
    "drill with chip breaking": "G0 Z3\nG73 X1 Z-3 R2 Q2 F10\nX2\nX3 Q1.5 Z-2\nG98 Y2\nG99 X1\nG20 G73 X1 Z-1 R.1 Q.2\n",
    "tapping": "G0 Z3\nM3 S100\nG84 X1 Z-3 R2 F10 P.5\nX2 L2\nX3 P1\nG99 X4\nX5\nG80\nM4\nG74 X1 Z-3 R2\nX2\n",
    "tapping with overrides off": "G0 Z3\nM49\nM3 S100\nG84 X1 Z-3 R2 F10\nM48\nM50 P0\nX2\nM51 P0\nM50\nX3\n",
    "more parameters of modes": "G0 X#<_abs_x> Y#<_ccomp> Z#<_lathe_radius_mode>\nT2 M6\nT3\nX#<_current_pocket> Y#<_selected_pocket>\n"
    "G43.1 Z2\nX#<_tool_offset> Y#<_ijk_absolute_mode> Z#<_retract_old_z>\nG49 G90.1 G99\n"
    "X#<_tool_offset> Y#<_ijk_absolute_mode> Z#<_retract_old_z>\nX#<_retract_r_plane> Y#<_remap_level> Z#<_task>\n"
    "X#<_vmajor> Y#<_vminor> Z#<_units_per_rev>\nX#<_u> Y#<_v> Z#<_w>\nX#<_lathe_diameter_mode>\n",
    "places of the machine": "G10 L2 P1 R90 X1\nG0 X3 Y4 Z5 A6 B7 C8\nG92 X1\n#1=#<_abs_x> #2=#<_abs_y> #3=#<_abs_z>\n"
    "#4=#<_abs_a> #5=#<_abs_b> #6=#<_abs_c>\nX#1 Y#2 Z#3 A#4 B#5 C#6\nG20\nX[#<_abs_x>] Y[#<_abs_y>]\n",
    "number of the line": "G0 X#<_line>\nX#<_line>\no1 sub\nX#<_line>\no1 endsub\no1 call\n(debug,#<_line>)\nX[#<_line>]\n",
    "exists by number": "#1=3\nG0 X[EXISTS[#1]] Y[EXISTS[#<_x>]] Z[EXISTS[#<a>]+EXISTS[#5399]]\n",
    "forms of numbers": "#1=3.7\n#2=-2.5\n(DEBUG,a %d #1 %f #1 %.2f #1 b #1)\n(debug,%lf %5.1f#1 % #1 %d#2 %d#<_x>)\n(MSG,%d#1)\n"
    "#3=0.99999\n(debug,%d#3 %.3f#3 %f#3 %.9f#3 %.0f#2)\n(debug,#3)\n",
    "saved state": "M70\nG20 G91 G18 G61 F20 S5 G55 M49 G99 G90.1 M3 M8 T2\nM72\nM71\nG0 X1\n",
    "saved coolant and spindle": "M7\nM3 S4\nM70\nM8 M5\nM9\nM72\nM9\nM70\nM52 P1\nM53 P0\nM72\n",
    "saved path control": "G61.1\nM70\nG64 P1\nM72\nG64 P1 Q2\nM70\nG61\nM72\nG0 X1\n",
    "saved feed and offset": "G93\nM70\nG94 F5\nG43.1 Z2\nM72\nG0 X1 Z1\nG94 F7\nM70\nF8\nM72\nG1 X2\n",
    "saved system": "G10 L2 P2 X5 R10\nG55\nM70\nG54\nM72\nG0 X1\n",
    "saved until the return": "o1 sub\nM73\nG91 F10 G20\nG0 X1\no1 endsub\nF5\no1 call\nG0 X1\nM98 P2\nG0 X1\nM2\nO2\nM73 G91\nG0 Y1\nM99\n",
    "safety line": "G0 G17 G40 G49 G80 G90\nX2\nG1 G80 F10\nX3\nG80 G80\n",
    "safety line after a cycle": "G0 Z5\nG81 X1 R1 Z-1 F10\nG80 G81 X2\nG80 G0 X3\nX4\n",
    "program number": "O1234\nG0 X1\n",
    "program name": "O<part>\nG0 X1\n",
    "subprograms": "O1\nG0 X1\nM98 P100 L2\nM98 L3 P0100\nM98 P200 L0\nM2\nO0100\nG91 G0 X1\nM98 P200\nM99\nO200\nG0 Y1\nN5 M99\nG0 X99\n",
    "parameters of subprograms": "#1=3\n#2=100\nM98 P#2\nG0 Y#1 Z#<_call_level>\nM2\nO100\nG0 X#1 Z#<_call_level>\n#1=5\nM99\n",
    "subprogram within a subroutine": "o1 sub\nM98 P100\no1 endsub\no1 call [7]\nM2\nO100\nG0 X#1\nM99\n",
    "end of the main program by M99": "G0 X1\nM99\nG0 X2\n",
    "end by M2 in a subprogram": "M98 P100\nG0 X2\nM2\nO100\nG0 X5\n",
    "a subprogram where it stands": "G0 X1\nO100\nG0 X5\nM99\nM98 P100\n",
    "computed numbers": "o100 sub\nG0 X#1\no100 endsub\n#1=100\no#1 call [1]\no[50+50] call [2]\n#<n>=100\no#<n> call [3]\n",
    "zeros before a number": "o5 sub\nG0 X2\no05 endsub\no005 call\no<5> call\n",
    "modes after the end": "G91 G55 G18 M49\n",
    "integers": "G[0] X1\nM[5]\nG1.0 X2 F10\n",
}

ENDED_BY_PERCENT = "%\nG0 X1\n%\nG0 X2\n"

BAD = {
    "no feed after g94": "F10\nG94\nG1 X1\nM2\n",
    "polar and x": "G0 X3 @4\nM2\n",
    "polar at the origin": "G0 @4\nM2\n",
    "surface speed without s": "G96\nM2\n",
    "two spindle modes": "G96 D1 G97 S1\nM2\n",
    "d without g96": "G97 D5\nM2\n",
    "tapping without a spindle": "G84 X1 Z-3 R2 F10\nM2\n",
    "tapping in the wrong direction": "M3 S1\nG74 X1 Z-3 R2 F10\nM2\n",
    "exists without a parameter": "G0 X[EXISTS[3]]\nM2\n",
    "nothing saved": "M72\nM2\n",
    "saved state forgotten": "M70\nM72\nM71\nM72\nM2\n",
    "abort": "G0 X1\n(abort, stop here)\nX2\nM2\n",
    "abort in a condition": "#1=2\no1 if [#1 GT 1]\nG0 X1 (ABORT,#1 is too large)\no1 endif\nG0 X2\nM2\n",
    "unknown subprogram": "M98 P7\nM2\n",
    "subprogram without a number": "M98\nM2\n",
    "negative repeats": "M98 P100 L-1\nM2\nO100\nM99\n",
    "m98 behind a word": "G0 Y5 M98 P100\nM2\nO100\nM99\n",
    "word behind m99": "M98 P100\nM2\nO100\nM99 P20\n",
    "m99 of a subroutine": "o100 sub\nG0 X1\nM99\no100 endsub\no100 call\nM2\n",
    "m98 of a subroutine": "o100 sub\nG0 X1\no100 endsub\nM98 P100\nM2\n",
    "call of a subprogram": "o100 call\nM2\no100\nG0 X1\nM99\n",
    "words behind a program number": "O1 G0 X1\nM2\n",
    "g80 with axes after a cycle": "G81 X1 R1 Z-1 F10\nG80 X3\nM2\n",
    "no feed": "G1 X1\nM2\n",
    "no feed for an arc": "G2 X1 I0.5\nM2\n",
    "no centre": "G2 X1 F10\nM2\n",
    "radii differ": "G2 X10 Y3 I5 F10\nM2\n",
    "radius too small": "G2 X1 Y1 R0.1 F10\nM2\n",
    "full circle with radius": "G2 X0 Y0 R5 F10\nM2\n",
    "no end of an arc": "G2 R5 F10\nM2\n",
    "wrong centre word": "G2 X10 I5 K1 F10\nM2\n",
    "absolute centre": "G90.1 G2 X10 I5 F10\nM2\n",
    "no turn": "G2 I5 P0 F10\nM2\n",
    "radius and centre": "G2 X10 I5 R5 F10\nM2\n",
    "two motions": "G0 G1 X1\nM2\n",
    "two coolants": "M7 M8\nM2\n",
    "two words": "G0 X1 X2\nM2\n",
    "no motion": "G80\nX5\nM2\n",
    "g80 with axes": "G80 X5\nM2\n",
    "unused p": "G0 X1 P5\nM2\n",
    "unused l": "G0 X1 L2\nM2\n",
    "unused h": "G0 X1 H2\nM2\n",
    "unused i": "G0 X1 I2\nM2\n",
    "unused q": "G1 X1 F10 Q2\nM2\n",
    "unused r": "G0 X1 R2\nM2\n",
    "negative feed": "F-1\nM2\n",
    "negative speed": "S-1\nM2\n",
    "no dwell time": "G4\nM2\n",
    "axes of a dwell": "G1 X1 F100\nG4 X1\nM2\n",
    "division by zero": "G0 X[1/0]\nM2\n",
    "root of a negative number": "G0 X[SQRT[-1]]\nM2\n",
    "logarithm of zero": "G0 X[LN[0]]\nM2\n",
    "arc sine": "G0 X[ASIN[2]]\nM2\n",
    "unknown function": "G0 X[FOO[2]]\nM2\n",
    "no bracket": "G0 X[1+2\nM2\n",
    "no value": "G0 X\nM2\n",
    "two points": "G0 X1.2.3\nM2\n",
    "parameter 0": "#0=1\nM2\n",
    "parameter 6000": "#6000=1\nM2\n",
    "parameter not whole": "#1=5.4\nG0 X##1\nM2\n",
    "undefined name": "G0 X#<nope>\nM2\n",
    "no name": "G0 X#<nope\nM2\n",
    "read only": "#<_metric>=1\nM2\n",
    "unknown code": "G12\nM2\n",
    "unknown m code": "M97\nM2\n",
    "bad character": "G0 X1 !\nM2\n",
    "open comment": "G0 X1 (abc\nM2\n",
    "nested comment": "(a(b))\nM2\n",
    "closing bracket": "G0 X1 ]\nM2\n",
    "unknown subroutine": "o5 call\nM2\n",
    "return outside": "G0 X1\no100 return\nM2\n",
    "return in the main program": "o1 return\nM2\n",
    "machine coordinates with an arc": "G53 G2 X1 I1 F10\nM2\n",
    "machine coordinates incremental": "G91 G53 G0 X1\nM2\n",
    "g92 without axes": "G92\nM2\n",
    "g52 without axes": "G52\nM2\n",
    "two users of axes": "G92 X1 G1 F10\nM2\n",
    "inverse time without f": "G93 G1 X10 F2\nX20\nM2\n",
    "cycle without r": "G81 X1 Z-1 F10\nM2\n",
    "cycle without z": "G81 X1 R1 F10\nM2\n",
    "cycle too high": "G81 X1 Z5 R2 F10\nM2\n",
    "cycle without repeats": "G81 X1 Z-1 R2 L0 F10\nM2\n",
    "cycle without feed": "G81 X1 Z-1 R2\nM2\n",
    "cycle without peck": "G83 X1 Z-1 R2 F10\nM2\n",
    "cycle with negative peck": "G83 X1 Z-1 R2 Q-1 F10\nM2\n",
    "cycle in inverse time": "G93 G81 X1 Z-1 R2 F10\nM2\n",
    "cycle turns": "G81 X1 A5 Z-1 R2 F10\nM2\n",
    "other cycle without r": "G81 X1 Z-1 R2 F10\nG82 X2 P1\nM2\n",
    "unknown tool": "T50\nM6\nM2\n",
    "unknown tool offset": "G43 H50\nM2\n",
    "g10 without l": "G10 P1 X1\nM2\n",
    "g10 without p": "G10 L2 X1\nM2\n",
    "g10 with system 10": "G10 L2 P10 X1\nM2\n",
    "wait without time": "M66 P0 L1 Q0\nM2\n",
    "wait for an analog input": "M66 E0 L3 Q1\nM2\n",
    "output without p": "M62\nM2\n",
    "analog output without e": "M67 Q1\nM2\n",
    "axis u": "G0 U1\nM2\n",
}


# What rs274 refuses and we accept: the files of other machines and of hobbyists.
WITHOUT_END = {"no end": "G0 X1\n", "one percent": "%\nG0 X1\n", "no line end": "G0 X1"}


def random_program(seed):
    """A valid program. The same seed gives the same program."""
    return Draw(random.Random(seed)).program()


class Draw:
    """Draws lines of a valid program and follows the modes that decide what is valid."""

    def __init__(self, rng):
        self.rng = rng
        self.lines = []
        self.inverse = False
        self.labels = 0
        # Where a rotation changes while an offset of G92 is active, rs274 forgets where the machine is.
        self.turns = rng.random() < 0.5

    def number(self, low=-50.0, high=50.0):
        """A value as text: a number, or an expression."""
        value = self.rng.uniform(low, high)
        kind = self.rng.randrange(12)
        if kind == 0:
            return f"[{value / 2:.3f}+{value / 2:.3f}]"
        if kind == 1:
            return f"#{self.rng.randrange(1, 9)}" if low < 0 else f"[ABS[#{self.rng.randrange(1, 9)}]+1]"
        if kind == 2:
            return f"[{value:.2f}*COS[{self.rng.randrange(0, 60)}]]"
        if kind == 3:
            return f"{value:.0f}."
        return f"{value:.{self.rng.randrange(1, 5)}f}"

    def axes(self, letters="XYZABC", least=1):
        some = self.rng.sample(letters, self.rng.randrange(least, len(letters) + 1))
        return " ".join(f"{letter}{self.number()}" for letter in some)

    def label(self):
        self.labels += 1
        return f"o{self.labels}"

    def feed(self):
        if self.inverse or self.rng.random() < 0.2:
            return f" F{self.rng.uniform(0.5, 500):.2f}"
        return ""

    def program(self):
        add = self.lines.append
        add(START.strip())
        add("F100")
        for i in range(1, 9):
            add(f"#{i}={self.rng.uniform(-20, 20):.3f}")
        for _ in range(self.rng.randrange(10, 40)):
            self.statement(0)
        add(self.rng.choice(["M2", "M30"]))
        return "\n".join(self.lines) + "\n"

    def statement(self, depth):
        kinds = ["straight"] * 8 + ["arc"] * 5 + ["mode"] * 4 + ["offset"] * 3 + ["assign"] * 3 + ["machine"] * 3
        kinds += ["cycle"] * 2
        if depth < 2:
            kinds += ["if", "repeat", "while", "sub"]
        getattr(self, "draw_" + self.rng.choice(kinds))(depth)

    def draw_straight(self, _depth):
        code = self.rng.choice(["G0", "G1"])
        self.lines.append(f"{code} {self.axes()}{self.feed() if code == 'G1' else ''}")

    def draw_arc(self, _depth):
        """Relative, so that the radii agree whatever the place is."""
        plane, first, second, normal, i, j = self.rng.choice(
            [("G17", "X", "Y", "Z", "I", "J"), ("G18", "Z", "X", "Y", "K", "I"), ("G19", "Y", "Z", "X", "J", "K")]
        )
        code = self.rng.choice(["G2", "G3"])
        helix = f" {normal}{self.rng.uniform(-5, 5):.3f}" if self.rng.random() < 0.4 else ""
        turns = f" P{self.rng.randrange(1, 4)}" if self.rng.random() < 0.2 else ""
        a, b = self.rng.uniform(1, 20), self.rng.uniform(1, 20)
        kind = self.rng.randrange(3)
        if kind == 0:
            arc = f"{first}{2 * a:.3f} {second}{2 * b:.3f} {i}{a:.3f} {j}{b:.3f}"
        elif kind == 1:
            arc = f"{i}{a:.3f} {j}{-b:.3f}"
        else:
            sign = self.rng.choice(["", "-"])
            arc = f"{first}{a:.3f} {second}{-b:.3f} R{sign}{a + b:.3f}"
        self.lines.append(f"{plane} G91 {code} {arc}{helix}{turns}{self.feed()}")
        self.lines.append(self.rng.choice(["G90", "G91"]))

    def draw_mode(self, _depth):
        kind = self.rng.randrange(9)
        if kind == 0:
            self.inverse = not self.inverse
            self.lines.append("G93" if self.inverse else "G94 F250")
        elif kind == 1:
            # rs274 does not convert tolerance and tool offset to the new units.
            self.lines += ["G49", self.rng.choice(["G20", "G21"]), "G64"]
        else:
            self.lines.append(
                self.rng.choice(
                    [
                        "G90",
                        "G91",
                        "G61",
                        "G61.1",
                        "G64",
                        "G64 P0.1",
                        "G64 P0.2 Q0.05",
                        "G17",
                        "G18",
                        "G19",
                        "G98",
                        "G99",
                    ]
                )
            )

    def draw_offset(self, _depth):
        kind = self.rng.randrange(9)
        flat = "XYZABC"
        if kind == 0:
            turn = f" R{self.rng.randrange(-90, 91, 15)}" if self.turns else ""
            self.lines.append(f"G10 L2 P{self.rng.randrange(0, 10)} {self.axes(flat)}{turn}")
        elif kind == 1:
            self.lines.append(f"G10 L20 P{self.rng.randrange(0, 10)} {self.axes(flat)}")
        elif kind == 2:
            self.lines.append("G" + self.rng.choice(["54", "55", "56", "57", "58", "59", "59.1", "59.2", "59.3"]))
        elif kind in (3, 4) and self.turns:
            self.lines.append("G54")
        elif kind == 3:
            self.lines.append(f"{self.rng.choice(['G92', 'G52'])} {self.axes(flat)}")
        elif kind == 4:
            self.lines.append(self.rng.choice(["G92.1", "G92.2", "G92.3"]))
        elif kind == 5:
            self.lines.append(self.rng.choice([f"G43.1 Z{self.number()}", "G49"]))
        elif kind == 6:
            self.lines.append(self.rng.choice(["G28.1", "G30.1", "G28", "G30", f"G28 Z{self.number()}"]))
        else:
            self.lines.append(f"G90 G53 {self.rng.choice(['G0', 'G0'])} {self.axes('XYZ', least=2)}")

    def draw_assign(self, _depth):
        operator = self.rng.choice(["+", "-", "*", "/", " MOD ", " LT ", " EQ ", " AND ", " OR ", " XOR ", " GE "])
        divisor = f"{self.rng.uniform(1, 9):.2f}"
        left = self.rng.choice([f"#{self.rng.randrange(1, 9)}", f"{self.rng.uniform(-9, 9):.2f}"])
        target = self.rng.randrange(1, 9)
        function = self.rng.choice(["ABS", "FIX", "FUP", "ROUND", "SIN", "COS"])
        self.lines.append(f"#{target}={self.rng.choice(['', function])}[{left}{operator}{divisor}]")
        self.lines.append(f"#{target}=[#{target} MOD 50]")

    def draw_machine(self, _depth):
        self.lines.append(
            self.rng.choice(
                ["M3 S100", "M4 S200.5", "M5", "M7", "M8", "M9", "M48", "M49", "M50 P0", "M51 P1", "M52", "M53 P0"]
                + ["M62 P1", "M63 P2", "M64 P3", "M65 P0", "M67 E1 Q2.5", "M68 E0 Q-3", "G4 P0.25", "M0", "M1", "M60"]
                + ["T1 M6", "T2", "(MSG, text)", "(debug,#1 #5)", "G80"]
            )
        )

    def draw_cycle(self, _depth):
        if self.inverse:
            return
        self.lines.append(self.rng.choice(["G17", "G18", "G19"]) + " G90 G80")
        self.lines.append("G0 X20 Y20 Z20")
        code = self.rng.choice(["G81", "G82", "G83"])
        extra = {"G81": "", "G82": " P0.5", "G83": f" Q{self.rng.uniform(2, 9):.2f}"}[code]
        mode = self.rng.choice(["G90", "G91"])
        if mode == "G91":
            place, clearance = "X-3 Y-2 Z-4", "R-5"
        else:
            place, clearance = "X-3.5 Y-2.5 Z-4.5", f"R{self.rng.choice([5, 25])}"
        repeat = f" L{self.rng.randrange(1, 4)}" if self.rng.random() < 0.4 else ""
        self.lines.append(f"{mode} {self.rng.choice(['G98', 'G99'])} {code} {place} {clearance}{extra}{repeat}")
        for _ in range(self.rng.randrange(3)):
            self.lines.append(self.rng.choice(["X-1 Y-2", "G98", "G99 X-2", "G98 Y-3 Z-6", "Z-7"]))
        self.lines.append("G80 G90")

    def block(self, depth):
        for _ in range(self.rng.randrange(1, 4)):
            self.statement(depth + 1)

    def draw_if(self, depth):
        label = self.label()
        self.lines.append(f"{label} if [#{self.rng.randrange(1, 9)} GT {self.rng.uniform(-9, 9):.1f}]")
        inverse = self.inverse
        self.block(depth)
        self.lines.append(f"{label} else")
        self.block(depth)
        self.lines.append(f"{label} endif")
        self.inverse = inverse
        self.lines.append("G93" if inverse else "G94 F250")

    def draw_repeat(self, depth):
        label = self.label()
        inverse = self.inverse
        self.lines.append(f"{label} repeat [{self.rng.randrange(0, 4)}]")
        self.lines.append("G93" if inverse else "G94 F250")
        self.block(depth)
        self.lines.append(f"{label} endrepeat")
        self.inverse = inverse
        self.lines.append("G93" if inverse else "G94 F250")

    def draw_while(self, depth):
        label = self.label()
        counter = 10 + self.labels
        inverse = self.inverse
        self.lines.append(f"#{counter}=0")
        self.lines.append(f"{label} while [#{counter} LT {self.rng.randrange(1, 4)}]")
        self.lines.append("G93" if inverse else "G94 F250")
        self.lines.append(f"#{counter}=[#{counter}+1]")
        self.block(depth)
        self.lines.append(f"{label} endwhile")
        self.inverse = inverse
        self.lines.append("G93" if inverse else "G94 F250")

    def draw_sub(self, depth):
        if depth > 0:
            return
        label = self.label()
        inverse = self.inverse
        self.lines.append(f"{label} sub")
        self.lines.append("G93" if inverse else "G94 F250")
        self.block(1)
        self.lines.append(f"{label} endsub")
        arguments = " ".join(f"[{self.rng.uniform(-9, 9):.2f}]" for _ in range(self.rng.randrange(8, 10)))
        self.lines.append(f"{label} call {arguments}")
        self.inverse = inverse
        self.lines.append("G93" if inverse else "G94 F250")
