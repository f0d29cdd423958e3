MODULE Seamwright
  ! Set-points of Seamwright over Externally Guided Motion (EGM), option 3124-1 (RobotWare 7) or 689-1 (RobotWare 6).
  ! Configuration, topic Communication: transmission protocol "seamwright" of type UDPUC, with the address of the
  ! computer and the port of `listen`. Start the program before the cell is switched on.
  !
  ! CommTimeout: without packets for 0.1 s EGM ends, the arm stops, and the program ends.
  ! EGM_STOP_HOLD: at the end the arm holds its position.
  VAR egmident egm_id;
  CONST egm_minmax within:=[-0.01,0.01];

  PROC main()
    EGMReset egm_id;
    EGMGetId egm_id;
    EGMSetupUC ROB_1, egm_id, "default", "seamwright" \Joint \CommTimeout:=0.1;
    EGMActJoint egm_id \J1:=within \J2:=within \J3:=within \J4:=within \J5:=within \J6:=within \LpFilter:=100 \SampleRate:=4 \MaxPosDeviation:=1000 \MaxSpeedDeviation:=200;
    ! It goes on while the arm follows: no condition ends it before an hour at rest.
    EGMRunJoint egm_id, EGM_STOP_HOLD \J1 \J2 \J3 \J4 \J5 \J6 \CondTime:=3600 \RampInTime:=0.05;
    EGMReset egm_id;
  ERROR
    IF ERRNO=ERR_UDPUC_COMM THEN
      EGMReset egm_id;
      TPWrite "Seamwright: no packets. Start the program again.";
      EXIT;
    ENDIF
  ENDPROC
ENDMODULE
